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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_OUTPUT_FILE_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_OUTPUT_FILE_H

#include "failure.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>

namespace Completion_program {

/*!
  A file that is either written completely or not at all. The text goes to a temporary file in the same folder, which
  takes the place of the target in `commit()` and is removed when `commit()` is not reached. Targets that are no regular
  files (a pipe, a terminal) are written directly.
*/
class Output_file
{
  typedef std::filesystem::path Path;

public:
  /// Opens the temporary file, so that a folder that cannot be written is known before the work starts.
  explicit Output_file(const std::string& name)
    : m_name(name)
  {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(name, error);
    if(std::filesystem::is_directory(status))
      throw Failure("cannot write " + name + ": it is a folder");
    m_target = std::filesystem::weakly_canonical(name, error);
    if(error)
      m_target = name;
    m_is_direct = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
    m_temporary = m_is_direct ? m_target : temporary_name(m_target);
    errno = 0;
    m_stream.open(m_temporary, std::ios::binary);
    if(!m_stream)
      throw Failure("cannot write " + name + ": " + reason());
    if(!m_is_direct && std::filesystem::exists(status))
      std::filesystem::permissions(m_temporary, status.permissions(), error);
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    if(m_is_committed || m_is_direct)
      return;
    m_stream.close();
    std::error_code ignored;
    std::filesystem::remove(m_temporary, ignored);
  }

  std::ofstream& stream() { return m_stream; }

  const Path& target() const { return m_target; }

  /// Ends the writing; the target is still as it was. \throw Failure if anything could not be written.
  void close()
  {
    errno = 0;
    m_stream.flush();
    if(!m_stream)
      throw Failure("cannot write " + m_name + ": " + reason());
    m_stream.close();
  }

  /// Puts the temporary file in the place of the target.
  void commit()
  {
    if(m_stream.is_open())
      close();
    if(!m_is_direct)
    {
      std::error_code error;
      std::filesystem::rename(m_temporary, m_target, error);
      if(error)
        throw Failure("cannot write " + m_name + ": " + error.message());
    }
    m_is_committed = true;
  }

private:
  static Path temporary_name(const Path& target)
  {
    std::random_device random;
    return target.parent_path() / ("." + target.filename().string() + "." + std::to_string(random()) + ".part");
  }

  static std::string reason()
  {
    return errno == 0 ? std::string("the file system refused it") : std::string(std::strerror(errno));
  }

  std::string m_name;
  Path m_target, m_temporary;
  std::ofstream m_stream;
  bool m_is_direct = false, m_is_committed = false;
};

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_OUTPUT_FILE_H
