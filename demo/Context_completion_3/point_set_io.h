// Copyright (c) 2026 The Context_completion_3 authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Context_completion_3 authors

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_POINT_SET_IO_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_POINT_SET_IO_H

#include "failure.h"
#include "las_io.h"
#include "ply_header.h"
#include "point_file.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/io.h>
#include <CGAL/Point_set_3/IO/OFF.h>
#include <CGAL/Point_set_3/IO/PLY.h>
#include <CGAL/Point_set_3/IO/XYZ.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <vector>

namespace Completion_program {

/// Takes what CGAL's readers say on the error stream, so that it can be part of our sentence.
class Captured_errors
{
public:
  Captured_errors() : m_previous(std::cerr.rdbuf(m_text.rdbuf())) {}
  Captured_errors(const Captured_errors&) = delete;
  Captured_errors& operator=(const Captured_errors&) = delete;
  ~Captured_errors() { std::cerr.rdbuf(m_previous); }

  /// The first line, or `otherwise`.
  std::string first_line(const std::string& otherwise) const
  {
    std::istringstream lines(m_text.str());
    std::string line;
    return std::getline(lines, line) && !line.empty() ? line : otherwise;
  }

private:
  std::ostringstream m_text;
  std::streambuf* m_previous;
};

/// The format that the extension of a file name stands for. \throw Failure if there is none
inline Format format_of(const std::string& name)
{
  std::string extension = std::filesystem::path(name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  if(extension == ".ply")
    return Format::ply;
  if(extension == ".xyz" || extension == ".pwn")
    return Format::xyz;
  if(extension == ".off")
    return Format::off;
  if(extension == ".obj")
    return Format::obj;
  if(extension == ".las" || extension == ".laz")
    return Format::las;
  throw Failure(name + ": unknown format" + (extension.empty() ? std::string() : " " + extension)
                + "; known are .ply, .xyz, .pwn, .off, .obj and .las");
}

/// The same for a file that is to be written. \throw Failure
inline Format format_for_writing(const std::string& name)
{
  const Format format = format_of(name);
  if(format == Format::las && std::tolower(static_cast<unsigned char>(name.back())) == 'z')
    throw Failure(name + ": compressed LAZ files cannot be written; .las can");
  if(format == Format::obj)
    throw Failure(name + ": the result is points without faces, for which there are .ply, .xyz, .pwn, .off and .las");
  return format;
}

namespace internal {

// number of points that the counts of an OFF file promise, -1 if they are not there as text
inline long long number_in_off_header(std::istream& stream)
{
  std::string line, word;
  while(std::getline(stream, line))
  {
    std::istringstream words(line.substr(0, line.find('#')));
    while(words >> word)
    {
      if(word.size() >= 3 && word.compare(word.size() - 3, 3, "OFF") == 0)
        continue;
      char* end = nullptr;
      const long long number = std::strtoll(word.c_str(), &end, 10);
      return *end == '\0' ? number : -1;
    }
  }
  return -1;
}

// the count that may stand alone on the first line of an XYZ file, -1 if there is none, and the longest line of numbers
inline long long number_in_xyz_header(std::istream& stream, std::size_t& columns)
{
  std::string line, word;
  long long number = -1;
  columns = 0;
  for(std::size_t i = 0; i < 100 && std::getline(stream, line); ++i)
  {
    std::istringstream words(line);
    std::size_t count = 0;
    while(words >> word && word[0] != '#')
      ++count;
    if(i == 0 && count > 0)
    {
      std::istringstream first(line);
      double x, y, z;
      if(count == 1 && !(first >> number))
        number = -1;
      // CGAL's reader takes any first line that begins with a number for a count
      if(count > 1 && !(first >> x >> y >> z))
        throw Failure("line 1 has no three coordinates");
    }
    columns = (std::max)(columns, count);
  }
  return number;
}

inline void check_number(const Point_file& file, long long promised)
{
  if(promised >= 0 && std::uint64_t(promised) != file.points.size())
    throw Failure("it is truncated or damaged: its header promises " + std::to_string(promised) + " points, but it has "
                  + std::to_string(file.points.size()));
}

// The faces of a file whose points have been read. What cannot be read as faces is no reason to refuse the points.
template <typename Reader>
void read_faces(std::istream& stream, Point_file& file, const Reader& reader)
{
  stream.clear();
  stream.seekg(0);
  std::vector<Point> points;
  const Captured_errors errors;
  bool is_read = reader(stream, points, file.faces) && points.size() == file.points.size();
  for(const std::vector<std::size_t>& face : file.faces)
    for(std::size_t v : face)
      is_read = is_read && v < points.size();
  if(!is_read)
  {
    file.faces.clear();
    file.notes.push_back("the faces cannot be read and are not used");
  }
}

inline void read_ply(std::istream& stream, std::uint64_t size, Point_file& file)
{
  const Ply_header header = read_ply_header(stream, size);
  file.is_ascii = header.is_ascii;
  CGAL::IO::set_mode(stream, header.is_ascii ? CGAL::IO::ASCII : CGAL::IO::BINARY);
  const Captured_errors errors;
  if(!CGAL::IO::read_PLY(stream, file.points, file.comments))
    throw Failure(errors.first_line("it is truncated, or what should be a number is none, at point "
                                    + std::to_string(file.points.size())));
  check_number(file, static_cast<long long>(header.number_of_vertices));
  if(header.has_faces)
  {
    file.notes.push_back("the faces are not kept");
    read_faces(stream, file, [](std::istream& s, std::vector<Point>& points, auto& faces)
      { return CGAL::IO::read_PLY(s, points, faces); });
  }
  for(const Ply_header::Property& property : header.vertex_properties)
    if(property.is_list)
      file.notes.push_back("the list property " + property.name + " is not kept");
}

inline void read_xyz(std::istream& stream, Point_file& file)
{
  std::size_t columns = 0;
  const long long promised = number_in_xyz_header(stream, columns);
  stream.clear();
  stream.seekg(0);
  const Captured_errors errors;
  if(!CGAL::IO::read_XYZ(stream, file.points))
    throw Failure(errors.first_line("it is damaged"));
  check_number(file, promised);
  if(columns > 6)
    file.notes.push_back("the columns behind the sixth are not kept");
}

inline void read_off(std::istream& stream, std::uint64_t size, Point_file& file)
{
  const long long promised = number_in_off_header(stream);
  if(promised > 0 && std::uint64_t(promised) > size)
    throw Failure("it is truncated: its header promises " + std::to_string(promised) + " points, but it has only "
                  + std::to_string(size) + " bytes");
  stream.clear();
  stream.seekg(0);
  const Captured_errors errors;
  if(!CGAL::IO::read_OFF(stream, file.points))
    throw Failure(errors.first_line("it is truncated or damaged"));
  check_number(file, promised);
  file.notes.push_back("only the points and normals are kept");
  read_faces(stream, file, [](std::istream& s, std::vector<Point>& points, auto& faces)
    { return CGAL::IO::read_OFF(s, points, faces); });
}

// lines that should be points
inline std::size_t number_in_obj(std::istream& stream)
{
  std::string line, word;
  std::size_t number = 0;
  while(std::getline(stream, line))
    number += std::istringstream(line) >> word && word == "v";
  return number;
}

inline void read_obj(std::istream& stream, Point_file& file)
{
  const std::size_t promised = number_in_obj(stream);
  stream.clear();
  stream.seekg(0);
  std::vector<Point> points;
  const bool is_read = CGAL::IO::read_OBJ(stream, points, file.faces);
  if(points.empty() || points.size() < promised)
    throw Failure("it is damaged, or no OBJ file: it cannot be read on after point " + std::to_string(points.size()));
  // points alone are no failure for us
  bool is_whole = is_read || file.faces.empty();
  for(const std::vector<std::size_t>& face : file.faces)
    for(std::size_t v : face)
      is_whole = is_whole && v < points.size();
  if(!is_whole)
    throw Failure("it is truncated or damaged: its faces cannot be read, or name a point that it does not have");
  for(const Point& p : points)
    file.points.insert(p);
  file.notes.push_back("only the points are kept");
}

} // namespace internal

/// Reads a point set with all its properties. \throw Failure with the name and the reason
inline void read_point_file(const std::string& name, Point_file& file)
{
  file.name = name;
  file.format = format_of(name);
  if(std::filesystem::is_directory(name))
    throw Failure("cannot read " + name + ": it is a folder");
  errno = 0;
  std::ifstream stream(name, std::ios::binary);
  if(!stream)
    throw Failure("cannot read " + name + ": " + (errno == 0 ? "the file system refused it" : std::strerror(errno)));
  stream.seekg(0, std::ios::end);
  const std::streamoff size = stream.tellg();
  stream.seekg(0);
  if(!stream || size < 0)
    throw Failure("cannot read " + name + ": it is no file on a disk");
  if(size == 0)
    throw Failure("cannot read " + name + ": it is empty");
  try
  {
    switch(file.format)
    {
    case Format::ply: internal::read_ply(stream, std::uint64_t(size), file); break;
    case Format::xyz: internal::read_xyz(stream, file); break;
    case Format::off: internal::read_off(stream, std::uint64_t(size), file); break;
    case Format::obj: internal::read_obj(stream, file); break;
    case Format::las: las::read(stream, std::uint64_t(size), file); break;
    }
  }
  catch(const Failure& failure)
  {
    throw Failure("cannot read " + name + ": " + failure.what());
  }
}

/*!
  Writes points so that they are read again bit for bit: in text with 17 digits.
  \param like the file that most of the points came from: encoding, comments, LAS header
*/
inline void write_point_file(std::ostream& stream, Format format, Point_set& points, const Point_file& like)
{
  stream.precision(17);
  switch(format)
  {
  case Format::ply:
    CGAL::IO::set_mode(stream, like.format == Format::ply && like.is_ascii ? CGAL::IO::ASCII : CGAL::IO::BINARY);
    CGAL::IO::write_PLY(stream, points, like.comments);
    break;
  case Format::xyz: CGAL::IO::write_XYZ(stream, points); break;
  case Format::off: CGAL::IO::write_OFF(stream, points); break;
  case Format::obj: throw Failure("OBJ files are read only");   // refused by `format_for_writing()`
  case Format::las: las::write(stream, points, like.las); break;
  }
}

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_POINT_SET_IO_H
