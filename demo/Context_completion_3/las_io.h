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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_LAS_IO_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_LAS_IO_H

#include "failure.h"
#include "point_file.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace Completion_program {

/*!
  LAS 1.0 to 1.4 without compression, point formats 0 to 10, on little-endian machines. CGAL reads LAS by LASlib, which
  Debian does not have; and it would lose the projection and all that its named properties do not cover. Here the record
  of each point is kept as it is: a point that was copied takes over its source's record, with its own coordinates.
*/
namespace las {

// offsets in the header
enum : std::size_t
{
  major_version = 24, minor_version = 25, header_size = 94, data_offset = 96, point_format = 104, record_length = 105,
  legacy_count = 107, legacy_counts_by_return = 111, scale = 131, shift = 155, bounds = 179, header_size_1_2 = 227,
  waveform_start = 227, extended_start = 235, count = 247, counts_by_return = 255, header_size_1_4 = 375
};

template <typename T>
T load(const std::string& bytes, std::size_t at)
{
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

template <typename T>
void store(std::string& bytes, std::size_t at, T value)
{
  std::memcpy(&bytes[at], &value, sizeof(T));
}

// offsets of the fields that formats share, 0 where a format has none
struct Layout
{
  std::size_t length, classification, user_data, source_id, time, color;
  bool is_extended;      // formats 6 to 10
};

inline Layout layout(unsigned int format)
{
  static const std::array<Layout, 11> layouts = { {
    { 20, 15, 17, 18, 0, 0, false },   { 28, 15, 17, 18, 20, 0, false },  { 26, 15, 17, 18, 0, 20, false },
    { 34, 15, 17, 18, 20, 28, false }, { 57, 15, 17, 18, 20, 0, false },  { 63, 15, 17, 18, 20, 28, false },
    { 30, 16, 17, 20, 22, 0, true },   { 36, 16, 17, 20, 22, 30, true },  { 38, 16, 17, 20, 22, 30, true },
    { 59, 16, 17, 20, 22, 0, true },   { 67, 16, 17, 20, 22, 30, true } } };
  return layouts[format];
}

inline unsigned int return_number(const std::string& record, bool is_extended)
{
  return static_cast<unsigned char>(record[14]) & (is_extended ? 15u : 7u);
}

/*!
  Applies `visit(name, offset, value of the type)` to the fields that have a property of their own in other formats.
  The names of the first ones are those of CGAL's `LAS_property`, the colours' those of PLY.
*/
template <typename Visitor>
void visit_fields(unsigned int format, Visitor&& visit)
{
  const Layout fields = layout(format);
  visit("intensity", std::size_t(12), std::uint16_t());
  visit("classification", fields.classification, std::uint8_t());
  visit("user_data", fields.user_data, std::uint8_t());
  visit("point_source_ID", fields.source_id, std::uint16_t());
  if(fields.time != 0)
    visit("gps_time", fields.time, double());
  if(fields.color != 0)
  {
    visit("red", fields.color, std::uint16_t());
    visit("green", fields.color + 2, std::uint16_t());
    visit("blue", fields.color + 4, std::uint16_t());
  }
}

inline std::uint64_t number_of_records(const std::string& header)
{
  const bool is_1_4 = header[major_version] == 1 && header[minor_version] >= 4 && header.size() >= header_size_1_4;
  return is_1_4 ? load<std::uint64_t>(header, count) : load<std::uint32_t>(header, legacy_count);
}

// the header of a new file, version 1.2, point format 0 or, with colours, 2
inline std::string new_header(const CGAL::Bbox_3& box, bool has_color)
{
  std::string header(header_size_1_2, '\0');
  header.replace(0, 4, "LASF");
  header[major_version] = 1;
  header[minor_version] = 2;
  header.replace(58, 16, "context_complete"); // generating software
  store<std::uint16_t>(header, header_size, header_size_1_2);
  store<std::uint32_t>(header, data_offset, header_size_1_2);
  header[point_format] = has_color ? 2 : 0;
  store<std::uint16_t>(header, record_length, std::uint16_t(layout(has_color ? 2 : 0).length));
  for(std::size_t i = 0; i < 3; ++i)
  {
    // the finest power of ten at which the extent and some room fit into 32 bits
    const double low = (box.min)(int(i)), high = (box.max)(int(i)), extent = (std::max)(high - low, 1e-9);
    store<double>(header, scale + 8 * i, std::pow(10., std::ceil(std::log10(extent / 1e9))));
    store<double>(header, shift + 8 * i, 0.5 * (low + high));
  }
  return header;
}

// the number of a coordinate in the file; \throw Failure if it does not fit
inline std::int32_t quantized(double coordinate, double scale, double shift)
{
  const double number = std::round((coordinate - shift) / scale);
  if(!(std::abs(number) <= (std::numeric_limits<std::int32_t>::max)()))
    throw Failure("a coordinate does not fit into the scale of the LAS header");
  return std::int32_t(number);
}

inline void read(std::istream& stream, std::uint64_t size, Point_file& file)
{
  std::string content(std::size_t(size), '\0');
  stream.read(&content[0], std::streamsize(size));
  if(size < header_size_1_2 || content.compare(0, 4, "LASF") != 0)
    throw Failure("it has no LAS header");
  const unsigned int format = static_cast<unsigned char>(content[point_format]);
  if(format >= 128)
    throw Failure("it is compressed (LAZ); uncompress it first, for example with laszip");
  const std::size_t length = load<std::uint16_t>(content, record_length);
  if(format > 10 || length < layout(format).length)
    throw Failure("its point format " + std::to_string(format) + " with records of " + std::to_string(length)
                  + " bytes is not known");
  const std::uint64_t begin = load<std::uint32_t>(content, data_offset);
  const std::uint64_t number = number_of_records(content);
  if(begin < load<std::uint16_t>(content, header_size) || begin > size || (size - begin) / length < number)
    throw Failure("it is truncated: its header promises " + std::to_string(number) + " points");

  file.las.before = content.substr(0, std::size_t(begin));
  file.las.after = content.substr(std::size_t(begin + number * length));
  std::array<double, 3> scales, shifts;
  for(std::size_t i = 0; i < 3; ++i)
  {
    scales[i] = load<double>(content, scale + 8 * i);
    shifts[i] = load<double>(content, shift + 8 * i);
  }
  file.points.reserve(std::size_t(number));
  auto records = file.points.add_property_map<std::string>("las_record").first;
  for(std::uint64_t i = 0; i < number; ++i)
  {
    const std::string record = content.substr(std::size_t(begin + i * length), length);
    const auto inserted = file.points.insert(Point(load<std::int32_t>(record, 0) * scales[0] + shifts[0],
                                                   load<std::int32_t>(record, 4) * scales[1] + shifts[1],
                                                   load<std::int32_t>(record, 8) * scales[2] + shifts[2]));
    put(records, *inserted, record);
  }
  visit_fields(format, [&](const char* name, std::size_t offset, auto type)
  {
    typedef decltype(type) Type;
    auto map = file.points.add_property_map<Type>(name).first;
    for(Point_set::Index i : file.points)
      put(map, i, load<Type>(get(records, i), offset));
  });
}

// the record of a point that did not come from a LAS file of the same layout: the only return, fields by their names
inline std::string new_record(Point_set& points, Point_set::Index i, unsigned int format, std::size_t length)
{
  std::string record(length, '\0');
  record[14] = layout(format).is_extended ? 0x11 : 0x09;
  visit_fields(format, [&](const char* name, std::size_t offset, auto type)
  {
    typedef decltype(type) Type;
    if(points.has_property_map<Type>(name))
      store<Type>(record, offset, get(points.add_property_map<Type>(name).first, i));
    else if(std::is_same<Type, std::uint16_t>::value && points.has_property_map<std::uint8_t>(name))
      // colours of 8 bits
      store<std::uint16_t>(record, offset,
                           std::uint16_t(257 * get(points.add_property_map<std::uint8_t>(name).first, i)));
  });
  return record;
}

inline bool has_color(const Point_set& points)
{
  for(const char* name : { "red", "green", "blue" })
    if(!points.has_property_map<std::uint8_t>(name) && !points.has_property_map<std::uint16_t>(name))
      return false;
  return true;
}

// counts and bounds of the header
inline void update_header(std::string& header, const std::vector<std::string>& records, std::uint64_t number_before)
{
  const unsigned int format = static_cast<unsigned char>(header[point_format]);
  const std::size_t length = load<std::uint16_t>(header, record_length);
  const bool is_1_4 = header[minor_version] >= 4 && load<std::uint16_t>(header, header_size) >= header_size_1_4;
  std::array<std::uint64_t, 15> by_return = {};
  std::array<std::int32_t, 3> low, high;
  low.fill((std::numeric_limits<std::int32_t>::max)());
  high.fill((std::numeric_limits<std::int32_t>::min)());
  for(const std::string& record : records)
  {
    const unsigned int number = return_number(record, layout(format).is_extended);
    if(number > 0)
      ++by_return[number - 1];
    for(std::size_t i = 0; i < 3; ++i)
    {
      low[i] = (std::min)(low[i], load<std::int32_t>(record, 4 * i));
      high[i] = (std::max)(high[i], load<std::int32_t>(record, 4 * i));
    }
  }
  const bool has_legacy = !layout(format).is_extended && records.size() <= (std::numeric_limits<std::uint32_t>::max)();
  store<std::uint32_t>(header, legacy_count, has_legacy ? std::uint32_t(records.size()) : 0u);
  for(std::size_t i = 0; i < 5; ++i)
    store<std::uint32_t>(header, legacy_counts_by_return + 4 * i, has_legacy ? std::uint32_t(by_return[i]) : 0u);
  if(is_1_4)
  {
    store<std::uint64_t>(header, count, records.size());
    for(std::size_t i = 0; i < by_return.size(); ++i)
      store<std::uint64_t>(header, counts_by_return + 8 * i, by_return[i]);
  }
  for(std::size_t i = 0; i < 3 && !records.empty(); ++i)
  {
    const double unit = load<double>(header, scale + 8 * i), origin = load<double>(header, shift + 8 * i);
    store<double>(header, bounds + 16 * i, high[i] * unit + origin);
    store<double>(header, bounds + 16 * i + 8, low[i] * unit + origin);
  }
  // what stands behind the records has moved
  const std::uint64_t old_end = load<std::uint32_t>(header, data_offset) + number_before * length;
  for(const std::size_t at : { std::size_t(waveform_start), std::size_t(extended_start) })
    if(header[minor_version] >= (at == waveform_start ? 3 : 4) && load<std::uint64_t>(header, at) >= old_end)
      store<std::uint64_t>(header, at, load<std::uint64_t>(header, at) + (records.size() - number_before) * length);
}

/// Writes all points; in a frame that was read, every input point's record is the one that was read.
inline void write(std::ostream& stream, Point_set& points, const Las_frame& frame)
{
  std::string header = frame.before;
  if(header.empty())
  {
    CGAL::Bbox_3 box;
    for(Point_set::Index i : points)
      box += points.point(i).bbox();
    header = new_header(points.empty() ? CGAL::Bbox_3(0, 0, 0, 1, 1, 1) : box, has_color(points));
  }
  const unsigned int format = static_cast<unsigned char>(header[point_format]);
  const std::size_t length = load<std::uint16_t>(header, record_length);
  const auto read_records = points.add_property_map<std::string>("las_record").first;
  std::vector<std::string> records;
  records.reserve(points.size());
  for(Point_set::Index i : points)
  {
    const bool is_kept = !frame.before.empty() && get(read_records, i).size() == length;
    records.push_back(is_kept ? get(read_records, i) : new_record(points, i, format, length));
    for(int c = 0; c < 3; ++c)
      store<std::int32_t>(records.back(), 4 * std::size_t(c), quantized(points.point(i)[c],
                          load<double>(header, scale + 8 * std::size_t(c)),
                          load<double>(header, shift + 8 * std::size_t(c))));
  }
  update_header(header, records, frame.before.empty() ? 0 : number_of_records(header));
  stream << header;
  for(const std::string& record : records)
    stream << record;
  stream << frame.after;
}

} // namespace las

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_LAS_IO_H
