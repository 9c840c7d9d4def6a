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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_PROGRESS_BAR_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_PROGRESS_BAR_H

#include <chrono>
#include <csignal>
#include <cstddef>
#include <functional>
#include <iostream>
#include <string>

#if defined(_WIN32)
#include <io.h>
#else
#include <unistd.h>
#endif

namespace Completion_program {

// set by the handler of interrupts: the work stops at the next report and nothing is written
inline volatile std::sig_atomic_t& interrupt_flag()
{
  static volatile std::sig_atomic_t flag = 0;
  return flag;
}

inline bool is_terminal(int descriptor)
{
#if defined(_WIN32)
  return _isatty(descriptor) != 0;
#else
  return isatty(descriptor) != 0;
#endif
}

/// The stage and how far it is, on one line of a terminal's error stream; silent elsewhere.
class Progress_bar
{
  typedef std::chrono::steady_clock Clock;

public:
  explicit Progress_bar(bool is_wanted)
    : m_is_shown(is_wanted && is_terminal(2))
  {}

  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  ~Progress_bar() { clear(); }

  /// Begins a stage, say "finding holes".
  void start(const std::string& stage)
  {
    set_stage(stage);
    report(0);
  }

  /// Names the stage and leaves the fraction as it is, till the next report.
  void set_stage(const std::string& stage)
  {
    clear();
    m_stage = stage;
    m_last = Clock::time_point();
  }

  /// \param fraction of the stage that is done. \return `false` after an interrupt: the work should stop.
  bool report(double fraction)
  {
    const Clock::time_point now = Clock::now();
    if(m_is_shown && now - m_last > std::chrono::milliseconds(100))
    {
      m_last = now;
      const std::size_t width = 30;
      const double bounded = fraction < 0 ? 0 : (fraction < 1 ? fraction : 1);
      const std::size_t done = std::size_t(bounded * double(width));
      std::cerr << '\r' << m_stage << " [" << std::string(done, '#') << std::string(width - done, '.') << "] "
                << int(bounded * 100) << " % " << std::flush;
      m_is_dirty = true;
    }
    return interrupt_flag() == 0;
  }

  /// For the callback parameter of the package.
  std::function<bool(double)> callback()
  {
    return [this](double fraction) { return report(fraction); };
  }

  /// Wipes the line, so that what follows begins at the margin.
  void clear()
  {
    if(m_is_dirty)
      std::cerr << "\r\x1b[K" << std::flush;
    m_is_dirty = false;
  }

private:
  std::string m_stage;
  Clock::time_point m_last;
  bool m_is_shown, m_is_dirty = false;
};

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_PROGRESS_BAR_H
