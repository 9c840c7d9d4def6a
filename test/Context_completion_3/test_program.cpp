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

// The program context_complete, run as a user runs it: formats, properties, reports, and what it refuses.

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace test_program {

namespace {

namespace fs = std::filesystem;

struct Row { std::array<double, 6> value; int red = 0; float quality = 0; };

/// A sphere of radius 1 in the order of a spiral; the cap where x exceeds `top` is missing.
std::vector<Row> sphere(double top, std::size_t number = 1500)
{
  std::vector<Row> rows;
  for(std::size_t i = 0; i < number; ++i)
  {
    const double z = 1 - 2 * (double(i) + 0.5) / double(number);
    const double angle = 2.399963229728653 * double(i), radius = std::sqrt(1 - z * z);
    if(radius * std::cos(angle) > top)
      continue;
    Row row;
    row.value = { radius * std::cos(angle), radius * std::sin(angle), z,
                  radius * std::cos(angle), radius * std::sin(angle), z };
    row.red = int(i % 251);
    row.quality = 0.1f * float(i);
    rows.push_back(row);
  }
  return rows;
}

std::string text_of(double number)
{
  std::ostringstream text;
  text.precision(17);
  text << number;
  return text.str();
}

std::string line_of(const Row& row, std::size_t columns)
{
  std::string line;
  for(std::size_t i = 0; i < columns; ++i)
    line += text_of(row.value[i]) + (i + 1 < columns ? " " : "");
  return line;
}

/// A PLY text; `columns` is 3 or 6, without or with normals.
std::string ply_of(const std::vector<Row>& rows, std::size_t columns = 6, bool has_properties = false)
{
  static const char* names[] = { "x", "y", "z", "nx", "ny", "nz" };
  std::string text = "ply\nformat ascii 1.0\ncomment made for a test\nelement vertex "
                     + std::to_string(rows.size()) + "\n";
  for(std::size_t i = 0; i < columns; ++i)
    text += std::string("property double ") + names[i] + "\n";
  if(has_properties)
    text += "property uchar red\nproperty float quality\n";
  text += "end_header\n";
  for(const Row& row : rows)
  {
    text += line_of(row, columns);
    if(has_properties)
      text += " " + std::to_string(row.red) + " " + text_of(double(row.quality));
    text += "\n";
  }
  return text;
}

std::string xyz_of(const std::vector<Row>& rows, std::size_t columns = 6)
{
  std::string text;
  for(const Row& row : rows)
    text += line_of(row, columns) + "\n";
  return text;
}

std::string read_file(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

/// The columns of a PLY file without lists, as numbers.
std::map<std::string, std::vector<double> > read_ply(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  std::string line, word, type, name;
  std::vector<std::pair<std::string, std::string> > properties;
  std::size_t number = 0;
  bool is_ascii = false;
  while(std::getline(stream, line) && line != "end_header")
  {
    std::istringstream words(line);
    words >> word >> type >> name;
    if(word == "format")
      is_ascii = type == "ascii";
    else if(word == "element")
      number = std::stoul(name);
    else if(word == "property")
      properties.emplace_back(name, type);
  }
  std::map<std::string, std::vector<double> > columns;
  for(const auto& property : properties)
    columns[property.first].reserve(number);
  for(std::size_t i = 0; i < number; ++i)
    for(const auto& property : properties)
    {
      double value = 0;
      const auto load = [&](auto typed)
      {
        stream.read(reinterpret_cast<char*>(&typed), sizeof typed);
        value = double(typed);
      };
      if(is_ascii)
        stream >> value;
      else if(property.second == "double")
        load(double());
      else if(property.second == "float")
        load(float());
      else if(property.second == "int")
        load(std::int32_t());
      else if(property.second == "ushort")
        load(std::uint16_t());
      else
        load(std::uint8_t());
      columns[property.first].push_back(value);
    }
  EXPECT_TRUE(stream.good() || stream.eof()) << path;
  return columns;
}

/// Numbers of the lines of an XYZ file.
std::vector<std::vector<double> > read_lines(const std::string& text)
{
  std::vector<std::vector<double> > lines;
  std::istringstream stream(text);
  std::string line;
  while(std::getline(stream, line))
  {
    std::istringstream words(line);
    std::vector<double> numbers;
    double number;
    while(words >> number)
      numbers.push_back(number);
    lines.push_back(numbers);
  }
  return lines;
}

/// A flat sheet of `number` by `number` points at height `z`.
std::vector<Row> sheet(int number, double z)
{
  std::vector<Row> rows;
  for(int i = 0; i < number; ++i)
    for(int j = 0; j < number; ++j)
    {
      Row row;
      row.value = { double(i), double(j), z, 0, 0, 1 };
      rows.push_back(row);
    }
  return rows;
}

/// Points and faces, and how files hold them.
struct Mesh
{
  std::string face_lines() const
  {
    std::string text;
    for(const std::vector<std::size_t>& face : faces)
    {
      text += std::to_string(face.size());
      for(std::size_t v : face)
        text += " " + std::to_string(v);
      text += "\n";
    }
    return text;
  }

  std::string off() const
  {
    return "OFF\n" + std::to_string(rows.size()) + " " + std::to_string(faces.size()) + " 0\n" + xyz_of(rows, 3)
           + face_lines();
  }

  std::string obj() const
  {
    std::istringstream lines(xyz_of(rows, 3));
    std::string text = "# a mesh\no mesh\n", line;
    while(std::getline(lines, line))
      text += "v " + line + "\n";
    for(const std::vector<std::size_t>& face : faces)
    {
      text += "f";
      for(std::size_t v : face)
        text += " " + std::to_string(v + 1);
      text += "\n";
    }
    return text;
  }

  std::string ply() const
  {
    std::string text = ply_of(rows);
    const std::string end = "end_header\n";
    text.insert(text.find(end), "element face " + std::to_string(faces.size())
                + "\nproperty list uchar int vertex_indices\n");
    return text + face_lines();
  }

  std::vector<Row> rows;
  std::vector<std::vector<std::size_t> > faces;
};

/// A sphere as a mesh: the grid of a cube, pushed outwards. The middle of its top has no points; one face may cover it.
struct Sphere_mesh : Mesh
{
  explicit Sphere_mesh(bool is_covered)
  {
    const int n = 20, first = 6, last = 14; // the grid of a side of the cube, and what is missing of the top
    const auto is_missing = [&](int i, int j) { return i > first && i < last && j > first && j < last; };
    std::map<std::array<int, 3>, std::size_t> index;
    const auto vertex = [&](const std::array<int, 3>& c)
    {
      const auto found = index.emplace(c, rows.size());
      if(found.second)
      {
        double p[3], length = 0;
        for(int d = 0; d < 3; ++d)
        {
          p[d] = std::tan(0.785398 * (2. * c[d] / n - 1)); // even angles
          length += p[d] * p[d];
        }
        Row row;
        for(int d = 0; d < 3; ++d)
          row.value[d] = row.value[d + 3] = p[d] / std::sqrt(length);
        rows.push_back(row);
      }
      return found.first->second;
    };
    for(int d = 0; d < 3; ++d)
      for(int side : { 0, n })
        for(int i = 0; i < n; ++i)
          for(int j = 0; j < n; ++j)
          {
            if(d == 2 && side == n && i >= first && i < last && j >= first && j < last)
              continue;
            std::vector<std::size_t> face;
            for(const auto& corner : { std::array<int, 2>{ i, j }, { i + 1, j }, { i + 1, j + 1 }, { i, j + 1 } })
            {
              std::array<int, 3> c;
              c[d] = side;
              c[(d + 1) % 3] = corner[0];
              c[(d + 2) % 3] = corner[1];
              EXPECT_FALSE(d == 2 && side == n && is_missing(corner[0], corner[1]));
              face.push_back(vertex(c));
            }
            if(side == 0)
              std::reverse(face.begin(), face.end());
            faces.push_back(face);
          }
    if(!is_covered)
      return;
    std::vector<std::size_t> lid;
    for(int i = first; i < last; ++i)
      lid.push_back(vertex({ i, first, n }));
    for(int j = first; j < last; ++j)
      lid.push_back(vertex({ last, j, n }));
    for(int i = last; i > first; --i)
      lid.push_back(vertex({ i, last, n }));
    for(int j = last; j > first; --j)
      lid.push_back(vertex({ first, j, n }));
    faces.push_back(lid);
  }
};

/// A sheet of squares, with holes where `is_missing(i, j)`, or rolled up to a tube along its first direction.
struct Sheet_mesh : Mesh
{
  Sheet_mesh(int n, const std::function<bool(int, int)>& is_missing, bool is_tube = false)
  {
    std::map<std::array<int, 2>, std::size_t> index;
    const auto vertex = [&](int i, int j)
    {
      const auto found = index.emplace(std::array<int, 2>{ is_tube ? i % n : i, j }, rows.size());
      if(found.second)
      {
        const double angle = 2 * 3.14159265358979 * i / n, radius = n / (2 * 3.14159265358979);
        Row row;
        if(is_tube)
          row.value = { radius * std::cos(angle), radius * std::sin(angle), double(j),
                        std::cos(angle), std::sin(angle), 0 };
        else
          row.value = { double(i), double(j), 0, 0, 0, 1 };
        rows.push_back(row);
      }
      return found.first->second;
    };
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
        if(!is_missing(i, j))
          faces.push_back({ vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1) });
  }
};

class Program : public testing::Test
{
protected:
  void SetUp() override
  {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    folder = fs::path(testing::TempDir()) / ("context_complete_" + std::string(info->name()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }

  void TearDown() override
  {
    // whatever happened, nothing half-written stays
    for(const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
      EXPECT_NE(entry.path().extension(), ".part") << entry.path();
    fs::remove_all(folder);
  }

  std::string write(const std::string& name, const std::string& content) const
  {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  std::string path(const std::string& name) const { return (folder / name).string(); }

  /// Runs the program; `out` and `err` then hold what it printed. \return the exit code
  int run(const std::string& arguments)
  {
    const std::string command = std::string(CONTEXT_COMPLETE_PROGRAM) + " " + arguments + " >" + path("out.txt")
                              + " 2>" + path("err.txt");
    const int status = std::system(command.c_str());
    out = read_file(path("out.txt"));
    err = read_file(path("err.txt"));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// The input is refused with exit code 1 and a sentence with `reason`, and an older OUTPUT stays as it was.
  void expect_refusal(const std::string& input, const std::string& reason, const std::string& options = "")
  {
    const std::string output = write("older.ply", "an older result");
    EXPECT_EQ(run(input + " " + output + " " + options), 1) << input;
    EXPECT_NE(err.find(reason), std::string::npos) << "expected '" << reason << "' in: " << err;
    EXPECT_NE(err.find(input), std::string::npos) << "the file is not named in: " << err;
    EXPECT_EQ(read_file(output), "an older result") << input;
    EXPECT_TRUE(out.empty()) << out;
  }

  void expect_usage_error(const std::string& arguments, const std::string& reason)
  {
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_NE(err.find(reason), std::string::npos) << "expected '" << reason << "' in: " << err;
    EXPECT_TRUE(out.empty()) << out;
  }

  fs::path folder;
  std::string out, err;
};

} // namespace

TEST_F(Program, Completes_and_keeps_properties)
{
  const std::vector<Row> rows = sphere(0.93);
  const std::string input = write("in.ply", ply_of(rows, 6, true));
  ASSERT_EQ(run(input + " " + path("out.ply") + " --added " + path("added.ply") + " --report "
                + path("report.json")), 0) << err;
  EXPECT_NE(out.find("points added"), std::string::npos) << out;
  EXPECT_TRUE(err.empty()) << err;

  auto result = read_ply(path("out.ply"));
  const std::size_t number = result["x"].size();
  ASSERT_GT(number, rows.size());
  const char* names[] = { "x", "y", "z", "nx", "ny", "nz" };
  for(std::size_t i = 0; i < rows.size(); ++i)
  {
    for(std::size_t j = 0; j < 6; ++j)
      ASSERT_EQ(result[names[j]][i], rows[i].value[j]) << i;
    ASSERT_EQ(result["red"][i], rows[i].red);
    ASSERT_EQ(float(result["quality"][i]), rows[i].quality);
    ASSERT_EQ(result["hole"][i], -1);
    ASSERT_EQ(result["source"][i], -1);
  }
  for(std::size_t i = rows.size(); i < number; ++i)
  {
    ASSERT_GE(result["hole"][i], 0);
    const double source = result["source"][i];
    ASSERT_LT(source, double(rows.size()));
    if(source >= 0)
    {
      ASSERT_EQ(result["red"][i], rows[std::size_t(source)].red);
    }
    const double radius = std::sqrt(result["x"][i] * result["x"][i] + result["y"][i] * result["y"][i]
                                    + result["z"][i] * result["z"][i]);
    EXPECT_NEAR(radius, 1, 0.05);
    EXPECT_GT(result["x"][i], 0.85);
  }
  EXPECT_NE(read_file(path("out.ply")).find("format ascii"), std::string::npos);
  EXPECT_NE(read_file(path("out.ply")).find("comment made for a test"), std::string::npos);

  auto added = read_ply(path("added.ply"));
  ASSERT_EQ(added["x"].size(), number - rows.size());
  for(const auto& column : added)
    EXPECT_TRUE(std::equal(column.second.begin(), column.second.end(),
                           result[column.first].begin() + std::ptrdiff_t(rows.size()))) << column.first;

  const nlohmann::json report = nlohmann::json::parse(read_file(path("report.json")));
  EXPECT_EQ(report.at("points"), rows.size());
  EXPECT_EQ(report.at("added"), number - rows.size());
  std::size_t sum = 0;
  for(const auto& hole : report.at("holes"))
    sum += hole.at("added").get<std::size_t>();
  EXPECT_EQ(sum, number - rows.size());
}

TEST_F(Program, Takes_and_gives_all_text_formats)
{
  const std::vector<Row> rows = sphere(0.93);
  const std::string off = "NOFF\n# a comment\n" + std::to_string(rows.size()) + " 0 0\n" + xyz_of(rows);
  const std::map<std::string, std::string> inputs = {
    { "in.ply", ply_of(rows) }, { "in.xyz", xyz_of(rows) }, { "in.off", off },
    { "in.pwn", std::to_string(rows.size()) + "\n" + xyz_of(rows) } };
  for(const auto& input : inputs)
    for(const std::string output : { "out.xyz", "out.pwn", "out.off" })
    {
      ASSERT_EQ(run(write(input.first, input.second) + " " + path(output) + " --quiet"), 0) << err;
      EXPECT_TRUE(out.empty() && err.empty()) << out << err;
      const std::vector<std::vector<double> > lines = read_lines(read_file(path(output)));
      std::size_t next = 0, found = 0;
      for(const std::vector<double>& line : lines)
        if(line.size() == 6 && next++ < rows.size())
          found += std::equal(line.begin(), line.end(), rows[next - 1].value.begin()) ? 1 : 0;
      EXPECT_EQ(found, rows.size()) << input.first << " to " << output;
      EXPECT_GT(next, rows.size()) << input.first << " to " << output;
    }
}

TEST_F(Program, Binary_input_gives_binary_output_with_the_same_numbers)
{
  const std::vector<Row> rows = sphere(0.93);
  std::string content = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(rows.size())
    + "\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\n"
      "property float ny\nproperty float nz\n"
      "property ushort label\nend_header\n";
  for(std::size_t i = 0; i < rows.size(); ++i)
  {
    content.append(reinterpret_cast<const char*>(rows[i].value.data()), 24);
    for(std::size_t j = 3; j < 6; ++j)
    {
      const float n = float(rows[i].value[j]);
      content.append(reinterpret_cast<const char*>(&n), sizeof n);
    }
    const std::uint16_t label = std::uint16_t(60000 + i);
    content.append(reinterpret_cast<const char*>(&label), sizeof label);
  }
  ASSERT_EQ(run(write("in.ply", content) + " " + path("out.ply")), 0) << err;
  EXPECT_NE(read_file(path("out.ply")).find("format binary_little_endian"), std::string::npos);
  auto result = read_ply(path("out.ply"));
  ASSERT_GT(result["x"].size(), rows.size());
  for(std::size_t i = 0; i < rows.size(); ++i)
  {
    ASSERT_EQ(result["y"][i], rows[i].value[1]);
    ASSERT_EQ(result["nz"][i], double(float(rows[i].value[5])));
    ASSERT_EQ(result["label"][i], double(60000 + i));
  }
}

TEST_F(Program, Result_can_be_input_again)
{
  ASSERT_EQ(run(write("in.ply", ply_of(sphere(0.93))) + " " + path("once.ply")), 0) << err;
  ASSERT_EQ(run(path("once.ply") + " " + path("twice.ply")), 0) << err;
  EXPECT_NE(err.find("hole_2"), std::string::npos) << err;
  auto once = read_ply(path("once.ply")), twice = read_ply(path("twice.ply"));
  ASSERT_EQ(twice["hole_2"].size(), twice["hole"].size());
  EXPECT_TRUE(std::equal(once["hole"].begin(), once["hole"].end(), twice["hole"].begin()));
}

TEST_F(Program, Output_may_be_the_input)
{
  const std::vector<Row> rows = sphere(0.93);
  const std::string file = write("in.xyz", xyz_of(rows));
  ASSERT_EQ(run(file + " " + file), 0) << err;
  EXPECT_GT(read_lines(read_file(file)).size(), rows.size());
}

TEST_F(Program, Says_that_there_is_no_hole)
{
  const std::vector<Row> rows = sphere(2);
  ASSERT_EQ(run(write("in.ply", ply_of(rows)) + " " + path("out.ply")), 0) << err;
  EXPECT_NE(out.find("no hole"), std::string::npos) << out;
  EXPECT_EQ(read_ply(path("out.ply"))["x"].size(), rows.size());
}

TEST_F(Program, Lists_holes_as_text_and_as_json)
{
  const std::string input = write("in.ply", ply_of(sphere(0.93)));
  ASSERT_EQ(run(input + " --list"), 0) << err;
  EXPECT_NE(out.find("1 hole"), std::string::npos) << out;
  ASSERT_EQ(run(input + " --list --json"), 0) << err;
  const nlohmann::json list = nlohmann::json::parse(out);
  ASSERT_EQ(list.at("holes").size(), 1u);
  const nlohmann::json& hole = list.at("holes").at(0);
  EXPECT_EQ(hole.at("state"), "hole");
  EXPECT_GT(hole.at("center").at(0).get<double>(), 0.8);
  EXPECT_NEAR(hole.at("diameter").get<double>(), 2 * std::sqrt(1 - 0.93 * 0.93), 0.15);
  EXPECT_GT(list.at("spacing").get<double>(), 0);
}

TEST_F(Program, Fills_only_what_is_asked_for)
{
  std::vector<Row> rows;
  for(const Row& row : sphere(0.93, 3000))
    if(row.value[1] > -0.94)
      rows.push_back(row);
  const std::string input = write("in.ply", ply_of(rows));
  ASSERT_EQ(run(input + " --list --json"), 0) << err;
  const nlohmann::json list = nlohmann::json::parse(out);
  ASSERT_EQ(list.at("holes").size(), 2u);
  for(const auto& hole : list.at("holes"))
  {
    const bool is_in_front = hole.at("center").at(0).get<double>() > 0.8;
    ASSERT_EQ(run(input + " " + path("out.ply") + " --holes " + hole.at("id").dump()), 0) << err;
    auto result = read_ply(path("out.ply"));
    ASSERT_GT(result["x"].size(), rows.size());
    for(std::size_t i = rows.size(); i < result["x"].size(); ++i)
    {
      ASSERT_GT(is_in_front ? result["x"][i] : -result["y"][i], 0.8);
    }
  }
  ASSERT_EQ(run(input + " " + path("out.ply") + " --box 0.5,-2,-2,2,2,2"), 0) << err;
  EXPECT_NE(out.find("1 excluded"), std::string::npos) << out;
  ASSERT_EQ(run(input + " " + path("out.ply") + " --exclude-box -2,-2,-2,2,2,2"), 0) << err;
  EXPECT_EQ(read_ply(path("out.ply"))["x"].size(), rows.size());
  ASSERT_EQ(run(input + " " + path("out.ply") + " --max-diameter 0.1"), 0) << err;
  EXPECT_EQ(read_ply(path("out.ply"))["x"].size(), rows.size());
  ASSERT_EQ(run(input + " " + path("out.ply") + " --min-diameter 1.5"), 0) << err;
  EXPECT_EQ(read_ply(path("out.ply"))["x"].size(), rows.size());
}

TEST_F(Program, Estimates_normals)
{
  const std::vector<Row> rows = sphere(0.93);
  ASSERT_EQ(run(write("in.xyz", xyz_of(rows, 3)) + " " + path("out.ply") + " --estimate-normals 18"), 0) << err;
  auto result = read_ply(path("out.ply"));
  ASSERT_GT(result["x"].size(), rows.size());
  for(std::size_t i = 0; i < rows.size(); ++i)
  {
    ASSERT_EQ(result["x"][i], rows[i].value[0]) << "the order has changed";
    ASSERT_GT(result["nx"][i] * rows[i].value[0] + result["ny"][i] * rows[i].value[1]
              + result["nz"][i] * rows[i].value[2],
              0.9);
  }
}

TEST_F(Program, Faces_of_a_mesh_give_normals)
{
  const Sphere_mesh mesh(false);
  const std::string input = write("in.off", mesh.off());
  ASSERT_EQ(run(input + " " + path("out.ply")), 0) << err;
  auto result = read_ply(path("out.ply"));
  ASSERT_GT(result["x"].size(), mesh.rows.size()) << "the hole at the border of the faces is one";
  for(std::size_t i = 0; i < result["x"].size(); ++i)
  {
    ASSERT_GT(result["nx"][i] * result["x"][i] + result["ny"][i] * result["y"][i]
              + result["nz"][i] * result["z"][i], 0.9);
  }
  expect_refusal(input, "--estimate-normals", "--ignore-faces");
}

TEST_F(Program, Meshes_in_obj_files_are_completed_as_those_in_off_files)
{
  const Sphere_mesh mesh(false);
  std::string results[2];
  const std::string inputs[] = { write("in.off", mesh.off()), write("in.obj", mesh.obj()) };
  for(int i = 0; i < 2; ++i)
  {
    ASSERT_EQ(run(inputs[i] + " " + path("out.xyz")), 0) << err;
    results[i] = read_file(path("out.xyz"));
  }
  EXPECT_GT(std::count(results[0].begin(), results[0].end(), '\n'), std::ptrdiff_t(mesh.rows.size()));
  EXPECT_EQ(results[0], results[1]);
  EXPECT_NE(err.find("only the points are kept"), std::string::npos) << err;
  // without faces they are points alone
  const std::string text = mesh.obj(), points = text.substr(0, text.find("\nf ") + 1);
  expect_refusal(write("points.obj", points), "--estimate-normals");
  ASSERT_EQ(run(path("points.obj") + " " + path("out.ply") + " --estimate-normals 18"), 0) << err;
  EXPECT_GT(read_ply(path("out.ply"))["x"].size(), mesh.rows.size());
  expect_refusal(write("faces.obj", text.substr(text.find("\nf ") + 1)), "no OBJ file");
  for(const std::string end : { "v 1 2 c\n", "v 1 2" })
    expect_refusal(write("damaged.obj", points + end), "after point " + std::to_string(mesh.rows.size()));
  expect_refusal(write("names.obj", points + "f 1 2 999999\n"), "name a point");
  EXPECT_EQ(run(inputs[1] + " " + path("out.obj")), 1);
  EXPECT_NE(err.find(".ply, .xyz, .pwn, .off and .las"), std::string::npos) << err;
  EXPECT_FALSE(fs::exists(path("out.obj")));
}

TEST_F(Program, What_the_faces_of_a_mesh_cover_is_no_hole)
{
  const Sphere_mesh mesh(true);
  for(const std::string& input :
      { write("in.off", mesh.off()), write("in.ply", mesh.ply()), write("in.obj", mesh.obj()) })
  {
    ASSERT_EQ(run(input + " " + path("out.ply")), 0) << err;
    EXPECT_EQ(read_ply(path("out.ply"))["x"].size(), mesh.rows.size());
    EXPECT_NE(out.find("1 covered by faces"), std::string::npos) << out;
    ASSERT_EQ(run(input + " --list --json"), 0) << err;
    const nlohmann::json list = nlohmann::json::parse(out);
    ASSERT_EQ(list.at("holes").size(), 1u);
    EXPECT_EQ(list.at("holes").at(0).at("state"), "covered by faces");
    for(const std::string named : { " --holes 0", " --hole-box -1,-1,0,1,1,2" })
    {
      ASSERT_EQ(run(input + " " + path("out.ply") + named), 0) << err;
      EXPECT_GT(read_ply(path("out.ply"))["x"].size(), mesh.rows.size())
        << "whoever names a hole gets it filled" << named;
    }
  }
  ASSERT_EQ(run(path("in.ply") + " " + path("out.ply") + " --ignore-faces"), 0) << err;
  EXPECT_GT(read_ply(path("out.ply"))["x"].size(), mesh.rows.size());
  // faces that make no sense are no reason to refuse the points
  std::string damaged = mesh.ply();
  damaged.erase(damaged.rfind('\n', damaged.size() - 2) + 1);
  damaged += "3 0 1 999999\n";
  ASSERT_EQ(run(write("damaged.ply", damaged) + " " + path("out.ply")), 0) << err;
  EXPECT_NE(err.find("the faces cannot be read"), std::string::npos) << err;
  EXPECT_GT(read_ply(path("out.ply"))["x"].size(), mesh.rows.size());
}

// Near each point of the full grid of a sheet there is one of the sheet or an added one.
void expect_covered(const Sheet_mesh& sheet, std::map<std::string, std::vector<double> > added)
{
  int last = 0;
  for(const Row& row : sheet.rows)
    last = (std::max)(last, int(row.value[0]));
  for(int i = 0; i <= last; ++i)
    for(int j = 0; j <= last; ++j)
    {
      double nearest = 100;
      for(const Row& row : sheet.rows)
        nearest = (std::min)(nearest, std::hypot(row.value[0] - i, row.value[1] - j));
      for(std::size_t k = 0; k < added["x"].size(); ++k)
        nearest = (std::min)(nearest, std::hypot(added["x"][k] - i, added["y"][k] - j));
      EXPECT_LT(nearest, 1.3) << i << " " << j;
    }
}

TEST_F(Program, A_border_within_a_mesh_is_the_rim_of_a_hole)
{
  // only two rows of points away from the outer border
  const Sheet_mesh sheet(40, [](int i, int j) { return i >= 8 && i < 32 && j >= 2 && j < 8; });
  const std::string input = write("in.ply", sheet.ply());
  const auto states = [&](const std::string& options)
  {
    std::map<std::string, int> result;
    EXPECT_EQ(run(input + " --list --json" + options), 0) << err;
    const nlohmann::json list = nlohmann::json::parse(out);
    for(const auto& hole : list.at("holes"))
      ++result[hole.at("state").get<std::string>()];
    return result;
  };
  EXPECT_EQ(states("")["hole"], 1) << err;
  EXPECT_EQ(states(" --ignore-faces")["hole"], 1) << "the points alone tell it, too";
  EXPECT_EQ(states(" --max-diameter 10").count("hole"), 0u);
  ASSERT_EQ(run(input + " " + path("out.ply") + " --added " + path("added.ply")), 0) << err;
  auto added = read_ply(path("added.ply"));
  expect_covered(sheet, added);
  for(std::size_t i = 0; i < added["x"].size(); ++i)
  {
    EXPECT_GT(added["x"][i], 8);
    EXPECT_LT(added["x"][i], 32);
    EXPECT_GT(added["y"][i], 2);
    EXPECT_LT(added["y"][i], 8);
  }
}

TEST_F(Program, The_border_of_a_sheet_and_the_ends_of_a_tube_stay_open)
{
  const Sheet_mesh sheet(30, [](int, int) { return false; }), tube(30, [](int, int) { return false; }, true);
  for(const std::string& text : { sheet.ply(), tube.ply() })
  {
    ASSERT_EQ(run(write("in.ply", text) + " " + path("out.ply")), 0) << err;
    EXPECT_NE(out.find("nothing was added"), std::string::npos) << out;
  }
}

TEST_F(Program, Holes_that_touch_in_a_point_have_a_rim_each)
{
  const Sheet_mesh sheet(40, [](int i, int j)
    { return (i >= 8 && i < 20 && j >= 8 && j < 20) || (i >= 20 && i < 32 && j >= 20 && j < 32); });
  ASSERT_EQ(run(write("in.ply", sheet.ply()) + " " + path("out.ply") + " --added " + path("added.ply")), 0) << err;
  expect_covered(sheet, read_ply(path("added.ply")));
  // a face that names a point twice bounds nothing
  std::string damaged = sheet.ply();
  const std::size_t at = damaged.rfind('\n', damaged.size() - 2) + 1;
  damaged.replace(at, std::string::npos, "4 0 1 1 2\n");
  ASSERT_EQ(run(write("damaged.ply", damaged) + " " + path("out.ply")), 0) << err;
}

TEST_F(Program, Complete_meshes_come_back_with_nothing_added)
{
  const char* data = std::getenv("CGAL_DATA_DIR");
  ASSERT_NE(data, nullptr) << "CGAL_DATA_DIR must name CGAL's data folder";
  for(const std::string model : { "bunny00", "femur", "armadillo" })
  {
    const std::string input = std::string(data) + "/meshes/" + model + ".off";
    ASSERT_EQ(run(input + " " + path("out.xyz")), 0) << err;
    EXPECT_NE(out.find("nothing was added"), std::string::npos) << model << ": " << out;
    std::istringstream header(read_file(input));
    std::string word;
    std::size_t number = 0;
    header >> word >> number;
    EXPECT_EQ(read_lines(read_file(path("out.xyz"))).size(), number) << model;
  }
}

TEST_F(Program, A_named_outer_border_stays_open)
{
  const std::vector<Row> rows = sheet(40, 0);
  const std::string input = write("in.ply", ply_of(rows));
  ASSERT_EQ(run(input + " --list --json"), 0) << err;
  const nlohmann::json list = nlohmann::json::parse(out);
  ASSERT_EQ(list.at("holes").size(), 1u);
  EXPECT_EQ(list.at("holes").at(0).at("state"), "outer border");
  ASSERT_EQ(run(input + " " + path("out.ply") + " --holes 0 --report " + path("report.json")), 0) << err;
  EXPECT_EQ(read_ply(path("out.ply"))["x"].size(), rows.size());
  const nlohmann::json report = nlohmann::json::parse(read_file(path("report.json")));
  EXPECT_NE(report.at("holes").at(0).at("reason").get<std::string>().find("opens outwards"), std::string::npos);
}

TEST_F(Program, Bad_examples_are_named)
{
  const std::string input = write("in.ply", ply_of(sphere(0.93)));
  const std::string missing = path("missing.ply"), few = write("few.ply", ply_of(std::vector<Row>(5))),
                    good = write("good.ply", ply_of(sphere(2)));
  EXPECT_EQ(run(input + " " + path("out.ply") + " --examples " + missing), 1);
  EXPECT_NE(err.find(missing), std::string::npos) << err;
  EXPECT_EQ(run(input + " " + path("out.ply") + " --examples " + good + " --examples " + few), 1);
  EXPECT_NE(err.find(few + ": "), std::string::npos) << err;
  EXPECT_EQ(err.find(input), std::string::npos) << err;
  EXPECT_FALSE(fs::exists(path("out.ply")));
}

TEST_F(Program, Takes_all_settings)
{
  const std::vector<Row> rows = sphere(0.93);
  const std::string input = write("in.ply", ply_of(rows)), example = write("example.ply", ply_of(sphere(2)));
  for(const std::string options : { "--nearest", "--no-mirrors --turns 8 --candidates 100",
                                   "--depth 5 --tolerance 0.01",
                                    "--min-cell-points 20 --seed 7 --threads 1", "--paper" })
  {
    ASSERT_EQ(run(input + " " + path("out.ply") + " " + options), 0) << options << err;
    EXPECT_GE(read_ply(path("out.ply"))["x"].size(), rows.size()) << options;
  }
  ASSERT_EQ(run(input + " " + path("out.ply") + " --examples " + example), 0) << err;
  EXPECT_EQ(read_ply(path("out.ply")).count("source_set"), 1u);
}

TEST_F(Program, Result_is_the_same_for_any_number_of_threads)
{
  const std::string input = write("in.ply", ply_of(sphere(0.93)));
  ASSERT_EQ(run(input + " " + path("one.ply") + " --threads 1"), 0) << err;
  ASSERT_EQ(run(input + " " + path("three.ply") + " --threads 3"), 0) << err;
  EXPECT_EQ(read_file(path("one.ply")), read_file(path("three.ply")));
}

namespace {

template <typename T>
void put_at(std::string& bytes, std::size_t at, T value) { std::memcpy(&bytes[at], &value, sizeof value); }

template <typename T>
T get_at(const std::string& bytes, std::size_t at)
{
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// LAS 1.2, point format 2 with 3 extra bytes, and a variable record before the points.
std::string las_of(const std::vector<Row>& rows)
{
  const std::size_t length = 29;
  std::string las(227, '\0');
  las.replace(0, 4, "LASF");
  las[24] = 1;
  las[25] = 2;
  put_at<std::uint16_t>(las, 94, 227);
  put_at<std::uint32_t>(las, 96, 227 + 54 + 10);
  put_at<std::uint32_t>(las, 100, 1);
  las[104] = 2;
  put_at<std::uint16_t>(las, 105, length);
  put_at<std::uint32_t>(las, 107, std::uint32_t(rows.size()));
  put_at<std::uint32_t>(las, 111, std::uint32_t(rows.size()));
  for(std::size_t i = 0; i < 3; ++i)
  {
    put_at<double>(las, 131 + 8 * i, 1e-4);
    put_at<double>(las, 155 + 8 * i, 1000. * double(i + 1));
  }
  std::string variable(54, '\0');
  put_at<std::uint16_t>(variable, 20, 10);
  las += variable + "projection";
  for(std::size_t k = 0; k < rows.size(); ++k)
  {
    std::string record(length, '\0');
    for(std::size_t i = 0; i < 3; ++i)
      put_at<std::int32_t>(record, 4 * i, std::int32_t(std::round(rows[k].value[i] * 1e4)));
    put_at<std::uint16_t>(record, 12, std::uint16_t(k));
    record[14] = 0x09;
    record[15] = char(k % 7);
    put_at<std::uint16_t>(record, 20, std::uint16_t(k));
    record[26] = char(k % 100);
    las += record;
  }
  return las;
}

} // namespace

TEST_F(Program, Keeps_the_records_of_las_files)
{
  const std::vector<Row> rows = sphere(0.93);
  const std::string las = las_of(rows), input = write("in.las", las);
  expect_refusal(input, "--estimate-normals");
  ASSERT_EQ(run(input + " " + path("out.las") + " --estimate-normals 18"), 0) << err;
  const std::string result = read_file(path("out.las"));
  const std::size_t begin = 227 + 64, length = 29, number = get_at<std::uint32_t>(result, 107);
  ASSERT_GT(number, rows.size());
  ASSERT_EQ(result.size(), begin + number * length);
  EXPECT_EQ(get_at<std::uint32_t>(result, 111), number);
  EXPECT_EQ(result.substr(227, 64), las.substr(227, 64));
  EXPECT_EQ(result.substr(begin, rows.size() * length), las.substr(begin, rows.size() * length));
  EXPECT_NEAR(get_at<double>(result, 195), 2001, 0.01);  // largest and smallest y
  EXPECT_NEAR(get_at<double>(result, 203), 1999, 0.01);

  // the other fields of a new point are those of one point of the input
  for(std::size_t i = rows.size(); i < number; ++i)
  {
    const std::string record = result.substr(begin + i * length, length);
    const std::size_t source = get_at<std::uint16_t>(record, 12);
    ASSERT_LT(source, rows.size());
    ASSERT_EQ(record.substr(12), las.substr(begin + source * length + 12, length - 12));
  }

  ASSERT_EQ(run(input + " " + path("out.ply") + " --estimate-normals 18"), 0) << err;
  auto columns = read_ply(path("out.ply"));
  for(std::size_t i = 0; i < rows.size(); ++i)
  {
    ASSERT_NEAR(columns["z"][i], 3000 + rows[i].value[2], 1e-4);
    ASSERT_EQ(columns["intensity"][i], double(i));
    ASSERT_EQ(columns["classification"][i], double(i % 7));
    ASSERT_EQ(columns["red"][i], double(i));
  }
  ASSERT_EQ(run(path("out.ply") + " " + path("again.las")), 0) << err;
  ASSERT_EQ(run(path("again.las") + " " + path("again.ply") + " --estimate-normals 18"), 0) << err;
  auto again = read_ply(path("again.ply"));
  for(std::size_t i = 0; i < rows.size(); ++i)
  {
    ASSERT_NEAR(again["x"][i], columns["x"][i], 1e-7);
    ASSERT_EQ(again["intensity"][i], double(i));
  }
}

TEST_F(Program, Refuses_damaged_las_files)
{
  const std::string las = las_of(sphere(0.93));
  expect_refusal(write("short.las", las.substr(0, las.size() - 1)), "truncated");
  expect_refusal(write("header.las", las.substr(0, 100)), "no LAS header");
  std::string compressed = las;
  compressed[104] = char(0x82);
  expect_refusal(write("compressed.laz", compressed), "LAZ");
  std::string unknown = las;
  unknown[104] = 42;
  expect_refusal(write("unknown.las", unknown), "point format 42");
}

TEST_F(Program, Refuses_files_that_cannot_be_read)
{
  expect_refusal(path("missing.ply"), "No such file");
  fs::create_directories(path("folder.ply"));
  expect_refusal(path("folder.ply"), "is a folder");
  expect_refusal(write("empty.ply", ""), "is empty");
  expect_refusal(write("in.stl", "solid"), "unknown format");
  expect_refusal(write("without_extension", "1 2 3"), "unknown format");
  expect_refusal(write("no.ply", "OFF\n"), "does not begin with the word ply");
  expect_refusal(write("letters.xyz", "this is text\n"), "line 1");
  expect_refusal(write("later.xyz", xyz_of(sphere(0.93)) + "1 2\n"), "Error line");
}

TEST_F(Program, Refuses_truncated_files)
{
  const std::vector<Row> rows = sphere(0.93);
  const std::string ply = ply_of(rows);
  expect_refusal(write("half.ply", ply.substr(0, ply.size() / 2)), "truncated");
  expect_refusal(write("header.ply", ply.substr(0, 60)), "header");
  expect_refusal(write("last.ply", ply.substr(0, ply.rfind(' '))), "truncated");
  std::string huge = ply;
  huge.replace(huge.find("vertex ") + 7, std::to_string(rows.size()).size(), "123456789012345678");
  expect_refusal(write("huge.ply", huge), "truncated");
  const std::string off = "NOFF\n" + std::to_string(rows.size()) + " 0 0\n" + xyz_of(rows);
  expect_refusal(write("half.off", off.substr(0, off.size() / 2)), "truncated");
  expect_refusal(write("half.pwn", std::to_string(rows.size()) + "\n" + xyz_of(sphere(0.5))), "truncated");
}

TEST_F(Program, Refuses_ply_files_that_the_reader_would_misread)
{
  const std::string head = "ply\nformat ascii 1.0\nelement vertex 1\n", end = "end_header\n1 2 3 4 5 6 7\n";
  const std::string xyz = "property double x\nproperty double y\nproperty double z\n";
  expect_refusal(write("a.ply", head + xyz + "property quad a\n" + end), "known type");
  expect_refusal(write("b.ply", head + "property int x\nproperty double y\nproperty double z\n" + end),
                 "no float or double");
  expect_refusal(write("c.ply", head + "property float x\nproperty double y\nproperty double z\n" + end),
                 "mixed types");
  expect_refusal(write("d.ply", head + "property double x\nproperty double y\n" + end), "no coordinate z");
  expect_refusal(write("e.ply", head + xyz + "property int index\n" + end), "reserved");
  expect_refusal(write("f.ply", head + xyz + "property int a\nproperty int a\n" + end), "twice");
  expect_refusal(write("g.ply", "ply\nformat utf8 1.0\n" + xyz + end), "no known format");
  expect_refusal(write("h.ply", "ply\nformat ascii 1.0\nend_header\n"), "no element vertex");
}

TEST_F(Program, Refuses_points_that_are_no_surface)
{
  const auto some = [](std::size_t n) { std::vector<Row> rows = sphere(2); rows.resize(n); return rows; };
  expect_refusal(write("none.ply", ply_of(some(0))), "no points");
  expect_refusal(write("one.ply", ply_of(some(1))), "1 points");
  expect_refusal(write("ten.ply", ply_of(some(10))), "10 points");
  std::vector<Row> rows(50);
  for(Row& row : rows)
    row.value = { 1, 2, 3, 0, 0, 1 };
  expect_refusal(write("equal.ply", ply_of(rows)), "equal");
  for(std::size_t i = 0; i < rows.size(); ++i)
    rows[i].value[0] = double(i);
  expect_refusal(write("line.ply", ply_of(rows)), "line");
}

TEST_F(Program, Takes_a_flat_sheet)
{
  const std::vector<Row> rows = sheet(30, 5);
  ASSERT_EQ(run(write("sheet.ply", ply_of(rows)) + " " + path("out.ply")), 0) << err;
  EXPECT_EQ(read_ply(path("out.ply"))["x"].size(), rows.size()) << "the border of a sheet is no hole";
}

TEST_F(Program, Refuses_bad_normals_and_coordinates)
{
  std::vector<Row> rows = sphere(0.93);
  expect_refusal(write("no_normals.ply", ply_of(rows, 3)), "--estimate-normals");
  expect_refusal(write("no_normals.xyz", xyz_of(rows, 3)), "--estimate-normals");
  expect_refusal(write("few.xyz", xyz_of(std::vector<Row>(rows.begin(), rows.begin() + 10), 3)), "10",
                 "--estimate-normals 18");
  rows[7].value = { rows[7].value[0], rows[7].value[1], rows[7].value[2], 0, 0, 0 };
  expect_refusal(write("zero.ply", ply_of(rows)), "Point 7 has the normal (0, 0, 0)");
  EXPECT_NE(err.find("--estimate-normals"), std::string::npos) << err;

  // in text CGAL reads no such numbers, in binary it does
  for(const std::size_t column : { 0, 4 })
    for(const double value : { std::nan(""), HUGE_VAL })
    {
      std::vector<Row> bad = sphere(0.93);
      bad[9].value[column] = value;
      std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(bad.size())
        + "\nproperty double x\nproperty double y\nproperty double z\nproperty double nx\nproperty double ny\n"
          "property double nz\nend_header\n";
      for(const Row& row : bad)
        binary.append(reinterpret_cast<const char*>(row.value.data()), 48);
      expect_refusal(write("binary.ply", binary), "Point 9 has the non-finite");
      expect_refusal(write("text.ply", ply_of(bad)), "point 9");
      expect_refusal(write("text.xyz", xyz_of(bad)), "line 10");
    }
}

TEST_F(Program, Refuses_outputs_that_cannot_be_written)
{
  const std::string input = write("in.ply", ply_of(sphere(0.93))), file = write("file", "x");
  for(const std::string& output : { path("missing/out.ply"), file + "/out.ply" })
  {
    EXPECT_EQ(run(input + " " + output), 1);
    EXPECT_NE(err.find("cannot write " + output), std::string::npos) << err;
    // a side file that cannot be written keeps OUTPUT from being written, too
    for(const std::string option : { " --added ", " --report " })
    {
      EXPECT_EQ(run(input + " " + path("out.ply") + option + output), 1);
      EXPECT_NE(err.find("cannot write " + output), std::string::npos) << err;
      EXPECT_FALSE(fs::exists(path("out.ply")));
    }
  }
  fs::create_directories(path("folder.ply"));
  EXPECT_EQ(run(input + " " + path("folder.ply")), 1);
  EXPECT_NE(err.find("is a folder"), std::string::npos) << err;
  EXPECT_EQ(run(input + " " + path("out.stl")), 1);
  EXPECT_NE(err.find("unknown format"), std::string::npos) << err;
  EXPECT_EQ(run(input + " " + path("out.laz")), 1);
  EXPECT_NE(err.find("LAZ"), std::string::npos) << err;
  EXPECT_EQ(read_file(file), "x");
}

TEST_F(Program, Explains_wrong_use)
{
  const std::string files = write("in.ply", ply_of(sphere(0.93))) + " " + path("out.ply"), input = path("in.ply");
  expect_usage_error("", "INPUT is missing");
  expect_usage_error(input, "OUTPUT is missing");
  expect_usage_error(files + " third.ply", "one file too many");
  expect_usage_error(files + " --unknown", "--unknown");
  expect_usage_error(files + " --list", "--list");
  expect_usage_error(input + " --list --report r.json", "--report");
  expect_usage_error(files + " --json", "--json");
  expect_usage_error(files + " --added", "--added");
  expect_usage_error(files + " --added " + path("out.ply"), "different files");
  const std::map<std::string, std::vector<std::string> > wrong = {
    { "--holes", { "x", "-1", "0,", "1.5", "99" } }, { "--min-diameter", { "0", "-1", "nan", "inf", "much", "1e999" } },
    { "--max-diameter", { "0", "-2", "nan", "" } }, { "--tolerance", { "0", "-0.1", "nan" } },
    { "--depth", { "0", "21", "-1", "2.5" } }, { "--min-cell-points", { "5", "100001", "many" } },
    { "--turns", { "0", "361" } }, { "--candidates", { "0", "10000001" } }, { "--seed", { "-1", "4294967296", "x" } },
    { "--threads", { "0", "1025" } }, { "--estimate-normals", { "0", "5", "1001", "-3" } },
    { "--box", { "1,2,3", "0,0,0,1,1,x", "1,0,0,0,1,1", "0,0,0,1,1,nan" } }, { "--exclude-box", { "0,0,0,-1,1,1" } } };
  for(const auto& option : wrong)
    for(const std::string& value : option.second)
      expect_usage_error(files + " " + option.first + " '" + value + "'", option.first);
  expect_usage_error(files + " --min-diameter 2 --max-diameter 1", "above");
  expect_usage_error(files + " --seed 1 --seed 2", "2 times");
  EXPECT_FALSE(fs::exists(path("out.ply")));
  EXPECT_EQ(run("--help"), 0);
  EXPECT_NE(out.find("--estimate-normals"), std::string::npos);
}

} // namespace test_program
