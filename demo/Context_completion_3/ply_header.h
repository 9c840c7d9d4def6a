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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_PLY_HEADER_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_PLY_HEADER_H

#include "failure.h"

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace Completion_program {

/*!
  The header of a PLY file, read before CGAL's reader is let at it. That reader skips properties of unknown type, takes
  the end of the file in the header for an empty point set, reserves whatever the header promises, needs coordinates of
  one floating-point type, and normals that are no wider. Each of these is told here in a sentence.
*/
struct Ply_header
{
  struct Property
  {
    std::string type, name;
    bool is_list = false;
  };

  bool is_ascii = false;
  bool has_faces = false;
  std::uint64_t number_of_vertices = 0;
  std::vector<Property> vertex_properties;

  const Property* find(const std::string& name) const
  {
    for(const Property& property : vertex_properties)
      if(property.name == name)
        return &property;
    return nullptr;
  }
};

// bytes of a PLY type, 0 if there is no such type
inline std::size_t size_of_ply_type(const std::string& type)
{
  static const std::map<std::string, std::size_t> sizes =
    { { "char", 1 }, { "int8", 1 }, { "uchar", 1 }, { "uint8", 1 },
      { "short", 2 }, { "int16", 2 }, { "ushort", 2 }, { "uint16", 2 },
      { "int", 4 }, { "int32", 4 }, { "uint", 4 }, { "uint32", 4 },
      { "float", 4 }, { "float32", 4 }, { "double", 8 }, { "float64", 8 } };
  const auto found = sizes.find(type);
  return found == sizes.end() ? 0 : found->second;
}

namespace internal {

// refuses what CGAL's reader cannot take
inline void check_ply_properties(const Ply_header& header)
{
  const auto is_single = [&](const std::string& name)
  {
    const Ply_header::Property* property = header.find(name);
    if(property == nullptr)
      throw Failure("its points have no coordinate " + name);
    const bool is_floating_point = property->type == "double" || property->type.compare(0, 5, "float") == 0;
    if(property->is_list || !is_floating_point)
      throw Failure("property " + name + " is no float or double");
    return size_of_ply_type(property->type) == 4;
  };
  const bool is_float = is_single("x");
  if(is_single("y") != is_float || is_single("z") != is_float)
    throw Failure("its coordinates are of mixed types, float and double");
  for(const char* name : { "nx", "ny", "nz" })
    if(header.find(name) != nullptr && !is_single(name) && is_float)
      throw Failure("its coordinates are of type float, but its normals of type double");
  for(std::size_t i = 0; i < header.vertex_properties.size(); ++i)
  {
    const std::string& name = header.vertex_properties[i].name;
    if(name == "index" || name == "point" || name == "normal")
      throw Failure("the property name " + name + " is reserved");
    for(std::size_t j = 0; j < i; ++j)
      if(header.vertex_properties[j].name == name)
        throw Failure("property " + name + " is there twice");
  }
}

} // namespace internal

/*!
  Reads and checks the header; `stream` is left where it was.
  \param size of the file in bytes, which tells truncated files
  \throw Failure with the reason, without the file's name
*/
inline Ply_header read_ply_header(std::istream& stream, std::uint64_t size)
{
  Ply_header header;
  std::string line, keyword, element;
  std::uint64_t record = 0; // smallest number of bytes that all elements need
  std::uint64_t number = 0;
  bool is_known_format = false, has_end = false, has_vertices = false;
  const std::istream::pos_type start = stream.tellg();
  for(std::size_t count = 0; !has_end && std::getline(stream, line); ++count)
  {
    std::istringstream words(line);
    if(!(words >> keyword))
      throw Failure("line " + std::to_string(count + 1) + " of the header is empty");
    if(count == 0)
    {
      if(keyword != "ply")
        throw Failure("it does not begin with the word ply");
    }
    else if(keyword == "format")
    {
      std::string format;
      words >> format;
      header.is_ascii = format == "ascii";
      is_known_format = header.is_ascii || format == "binary_little_endian" || format == "binary_big_endian";
    }
    else if(keyword == "element")
    {
      long long value = -1;
      if(!(words >> element >> value) || value < 0)
        throw Failure("line " + std::to_string(count + 1) + " of the header is no element with a count");
      number = std::uint64_t(value);
      if(number > size)
        throw Failure("it is truncated: its header promises " + std::to_string(number) + " of the element " + element
                      + ", but it has only " + std::to_string(size) + " bytes");
      if(element == "vertex" || element == "vertices")
      {
        header.number_of_vertices = number;
        has_vertices = true;
      }
      else if(element == "face" && number > 0)
        header.has_faces = true;
    }
    else if(keyword == "property")
    {
      Ply_header::Property property;
      std::string count_type;
      words >> property.type;
      if(property.type == "list")
      {
        property.is_list = true;
        words >> count_type >> property.type;
      }
      words >> property.name;
      if(!words || size_of_ply_type(property.type) == 0 || (property.is_list && size_of_ply_type(count_type) == 0))
        throw Failure("line " + std::to_string(count + 1) + " of the header is no property of a known type");
      record += number * (header.is_ascii ? 2 : size_of_ply_type(property.is_list ? count_type : property.type));
      if(element == "vertex" || element == "vertices")
        header.vertex_properties.push_back(property);
    }
    else if(keyword == "end_header")
      has_end = true;
  }
  if(!has_end)
    throw Failure("its header has no end");
  if(!is_known_format)
    throw Failure("its header names no known format");
  if(!has_vertices)
    throw Failure("its header has no element vertex");
  stream.clear(); // the header may end with the file
  const std::uint64_t rest = size - std::uint64_t(stream.tellg() - start);
  // the last number of a text needs no character behind it
  if(rest + (header.is_ascii ? 1 : 0) < record)
    throw Failure("it is truncated: its header promises " + std::to_string(header.number_of_vertices)
                  + " points, but only " + std::to_string(rest) + " bytes follow");
  internal::check_ply_properties(header);
  stream.seekg(start);
  return header;
}

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_PLY_HEADER_H
