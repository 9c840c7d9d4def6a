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

#ifndef CGAL_LICENSE_CONTEXT_COMPLETION_3_H
#define CGAL_LICENSE_CONTEXT_COMPLETION_3_H

// Stands in for the header that CGAL generates from its list of GPL packages.

#include <CGAL/config.h>
#include <CGAL/license.h>

#endif // CGAL_LICENSE_CONTEXT_COMPLETION_3_H
