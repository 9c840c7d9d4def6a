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

#ifndef CGAL_CONTEXT_COMPLETION_3_DEMO_FAILURE_H
#define CGAL_CONTEXT_COMPLETION_3_DEMO_FAILURE_H

#include <stdexcept>
#include <string>

namespace Completion_program {

/// Bad input or output: a sentence that names the file and the reason. Exit code 1.
struct Failure : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// Wrong use of the command line. Exit code 2.
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

} // namespace Completion_program

#endif // CGAL_CONTEXT_COMPLETION_3_DEMO_FAILURE_H
