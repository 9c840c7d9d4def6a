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

#ifndef CGAL_CONTEXT_COMPLETION_3_BENCHMARK_TIME_LIMIT_H
#define CGAL_CONTEXT_COMPLETION_3_BENCHMARK_TIME_LIMIT_H

#include "Benchmark_surface.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace Completion_benchmark {

namespace internal {

struct Close_file { void operator()(std::FILE* f) const { std::fclose(f); } };

template <typename Value>
bool write_values(std::FILE* file, const std::vector<Value>& values)
{
  const std::size_t n = values.size();
  return std::fwrite(&n, sizeof(n), 1, file) == 1 && std::fwrite(values.data(), sizeof(Value), n, file) == n;
}

template <typename Value>
bool read_values(std::FILE* file, std::vector<Value>& values)
{
  std::size_t n = 0;
  if(std::fread(&n, sizeof(n), 1, file) != 1)
    return false;
  values.resize(n);
  return std::fread(values.data(), sizeof(Value), n, file) == n;
}

} // namespace internal

/*!
  Computes a surface in a process of its own, which is killed after `seconds`: a mesher that does not end, as Poisson
  reconstruction on some open surfaces, must not hold up the other cases.
  \exception std::runtime_error if there is no surface, for any reason
*/
inline Benchmark_surface surface_within(double seconds, const std::function<Benchmark_surface()>& compute)
{
  const std::unique_ptr<std::FILE, internal::Close_file> file(std::tmpfile());
  if(!file)
    throw std::runtime_error("no temporary file");
  const pid_t child = fork();
  if(child < 0)
    throw std::runtime_error("no further process");
  if(child == 0)
  {
    bool is_done = false;
    try
    {
      const Benchmark_surface surface = compute();
      is_done = internal::write_values(file.get(), surface.vertices) &&
                internal::write_values(file.get(), surface.faces)
                && std::fflush(file.get()) == 0;
    }
    catch(const std::exception& e)
    {
      std::fprintf(stderr, "%s\n", e.what());
    }
    _exit(is_done ? 0 : 1);
  }
  const auto start = std::chrono::steady_clock::now();
  int status = 0;
  while(waitpid(child, &status, WNOHANG) == 0)
  {
    if(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > seconds)
    {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      throw std::runtime_error("no surface within " + std::to_string(int(seconds)) + " s");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if(!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error("no surface");
  std::rewind(file.get());
  Benchmark_surface surface;
  if(!internal::read_values(file.get(), surface.vertices) || !internal::read_values(file.get(), surface.faces))
    throw std::runtime_error("the surface could not be read back");
  return surface;
}

} // namespace Completion_benchmark

#endif // CGAL_CONTEXT_COMPLETION_3_BENCHMARK_TIME_LIMIT_H
