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

// The coarse to fine loop alone, with policies that copy nothing but keep a record of what they were asked for.

#include <CGAL/Context_completion_3/internal/Completion_loop.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace test_completion_loop {

using namespace CGAL::Context_completions_3::internal;

namespace {

typedef std::vector<std::string> Record;

struct Cell
{
  bool is_valid = false;
  bool has_match = true;
  std::size_t level = 0;                   // where it is a target
  std::vector<std::size_t> neighbors;
  std::vector<std::size_t> also_completed; // by the patch of this one
};

// Cells that are completed one by one. All calls that change or choose something go into the record.
class Cell_policy
{
public:
  typedef std::size_t Target;
  struct Match { std::size_t target; bool is_found; };
  struct Patch { std::size_t target; };

  explicit Cell_policy(const std::vector<Cell>& cells_, std::size_t first = 0, std::size_t last = 0)
    : cells(cells_), m_first(first), m_last(last)
  {}

  std::size_t first_level() const { return m_first; }
  bool is_last_level(std::size_t level)
  {
    note("last?", level);
    return level == m_last;
  }
  void begin_level(std::size_t level) { note("begin", level); }
  void end_level(std::size_t level) { note("end", level); }

  std::vector<Target> find_invalid(std::size_t level)
  {
    note("find", level);
    std::vector<Target> targets;
    for(std::size_t i = 0; i < cells.size(); ++i)
      if(!cells[i].is_valid && cells[i].level == level)
        targets.push_back(i);
    return targets;
  }

  std::size_t number_of_valid_neighbors(Target target) const
  {
    return std::size_t(std::count_if(cells[target].neighbors.begin(), cells[target].neighbors.end(),
                                     [this](std::size_t i) { return cells[i].is_valid; }));
  }

  bool is_still_invalid(Target target) const { return !cells[target].is_valid; }

  Match find_best_match(Target target, const Poll&)
  {
    note("match", target);
    return { target, cells[target].has_match };
  }

  bool is_found(const Match& match) const { return match.is_found; }

  Patch transfer(Target target, const Match& match)
  {
    EXPECT_EQ(match.target, target);
    note("transfer", target);
    return { target };
  }

  void insert(Target target, const Match& match, const Patch& patch)
  {
    EXPECT_EQ(match.target, target);
    EXPECT_EQ(patch.target, target);
    note("insert", target);
    inserted.push_back(target);
    cells[target].is_valid = true;
    for(std::size_t i : cells[target].also_completed)
      cells[i].is_valid = true;
  }

  double progress(std::size_t level, double fraction) const
  {
    return (double(level - m_first) + fraction) / double(m_last - m_first + 1);
  }

  std::vector<Cell> cells;
  std::vector<std::size_t> inserted;
  Record record;

private:
  void note(const std::string& what, std::size_t index) { record.push_back(what + " " + std::to_string(index)); }

  std::size_t m_first, m_last;
};

typedef Completion_loop<Cell_policy> Loop;

void run(Cell_policy& policy)
{
  const Loop::Callback callback;
  EXPECT_TRUE(Loop(policy, callback).run());
}

// 0 - 1 - ... - n-1
std::vector<Cell> chain(std::size_t n)
{
  std::vector<Cell> cells(n);
  for(std::size_t i = 0; i + 1 < n; ++i)
  {
    cells[i].neighbors.push_back(i + 1);
    cells[i + 1].neighbors.push_back(i);
  }
  return cells;
}

// Some cells are valid, some have no match, and some patches complete another cell, too.
std::vector<Cell> random_cells(unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<Cell> cells(60);
  for(std::size_t i = 0; i < cells.size(); ++i)
  {
    cells[i].is_valid = random() % 4 == 0;
    cells[i].has_match = random() % 5 != 0;
    if(random() % 8 == 0)
      cells[i].also_completed.push_back(random() % cells.size());
    for(int k = 0; k < 3; ++k)
    {
      const std::size_t j = random() % cells.size();
      if(j == i || std::count(cells[i].neighbors.begin(), cells[i].neighbors.end(), j) != 0)
        continue;
      cells[i].neighbors.push_back(j);
      cells[j].neighbors.push_back(i);
    }
  }
  return cells;
}

// The order of the insertions by definition: whenever it has to choose, it sorts all that is left.
std::vector<std::size_t> simulated_order(std::vector<Cell> cells, bool is_count_frozen)
{
  const std::vector<Cell> first = cells;
  const auto count = [&](std::size_t target)
  {
    std::size_t number = 0;
    for(std::size_t j : cells[target].neighbors)
      number += is_count_frozen ? first[j].is_valid : cells[j].is_valid;
    return number;
  };
  std::vector<std::size_t> left, order;
  for(std::size_t i = 0; i < cells.size(); ++i)
    if(!cells[i].is_valid)
      left.push_back(i);
  while(!left.empty())
  {
    std::vector<std::size_t> sorted = left;
    std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) { return count(a) > count(b); });
    const std::size_t target = sorted.front();
    left.erase(std::find(left.begin(), left.end(), target));
    if(cells[target].is_valid || !cells[target].has_match)
      continue;
    order.push_back(target);
    cells[target].is_valid = true;
    for(std::size_t i : cells[target].also_completed)
      cells[i].is_valid = true;
  }
  return order;
}

// Three levels of which the middle one has no target; a cell of the last one is completed by another.
std::vector<Cell> cells_of_three_levels()
{
  std::vector<Cell> cells = chain(6);
  for(std::size_t i = 0; i < cells.size(); ++i)
    cells[i].level = i < 3 ? 4 : 6;
  cells[1].has_match = false;
  cells[3].also_completed.push_back(5);
  return cells;
}

} // namespace

TEST(Completion_loop, Grows_from_what_is_valid)
{
  std::vector<Cell> cells = chain(6);
  cells[5].is_valid = true;
  Cell_policy policy(cells);
  run(policy);
  // had the neighbours been counted once, 0 would come second
  EXPECT_EQ(policy.inserted, (std::vector<std::size_t>{ 4, 3, 2, 1, 0 }));
}

TEST(Completion_loop, The_earlier_one_comes_first_among_equals)
{
  Cell_policy apart(std::vector<Cell>(5));
  run(apart);
  EXPECT_EQ(apart.inserted, (std::vector<std::size_t>{ 0, 1, 2, 3, 4 }));

  std::vector<Cell> cells = chain(7);
  cells[3].is_valid = true;
  Cell_policy both_sides(cells);
  run(both_sides);
  EXPECT_EQ(both_sides.inserted, (std::vector<std::size_t>{ 2, 1, 0, 4, 5, 6 }));
}

TEST(Completion_loop, Order_is_that_of_a_simulation_on_random_graphs)
{
  std::size_t differing = 0;
  for(unsigned int seed = 1; seed <= 50; ++seed)
  {
    const std::vector<Cell> cells = random_cells(seed);
    Cell_policy policy(cells);
    run(policy);
    EXPECT_EQ(policy.inserted, simulated_order(cells, false)) << "seed " << seed;
    differing += policy.inserted != simulated_order(cells, true);
  }
  EXPECT_GT(differing, 40u) << "these graphs do not tell whether neighbours are counted anew";
}

TEST(Completion_loop, A_target_that_was_completed_meanwhile_is_skipped)
{
  std::vector<Cell> cells(3);
  cells[0].also_completed.push_back(1);
  Cell_policy policy(cells);
  run(policy);
  EXPECT_EQ(policy.record, (Record{ "begin 0", "find 0", "match 0", "transfer 0", "insert 0",
                                    "match 2", "transfer 2", "insert 2", "end 0", "last? 0" }));
}

TEST(Completion_loop, A_target_without_a_match_is_not_inserted)
{
  std::vector<Cell> cells = chain(4);
  cells[0].is_valid = true;
  cells[1].has_match = false;
  Cell_policy policy(cells);
  run(policy);
  // 1 stays invalid, so that 2 and 3 are equal
  EXPECT_EQ(policy.record, (Record{ "begin 0", "find 0", "match 1", "match 2", "transfer 2", "insert 2",
                                    "match 3", "transfer 3", "insert 3", "end 0", "last? 0" }));
  EXPECT_FALSE(policy.cells[1].is_valid);
}

TEST(Completion_loop, Runs_from_the_first_level_to_the_last_and_through_empty_ones)
{
  Cell_policy policy(cells_of_three_levels(), 4, 6);
  run(policy);
  EXPECT_EQ(policy.record, (Record{
    "begin 4", "find 4", "match 0", "transfer 0", "insert 0", "match 1", "match 2", "transfer 2", "insert 2", "end 4",
    "last? 4", "begin 5", "find 5", "end 5", "last? 5",
    "begin 6", "find 6", "match 3", "transfer 3", "insert 3", "match 4", "transfer 4", "insert 4", "end 6",
    "last? 6" }));
}

TEST(Completion_loop, Nothing_to_do_is_done)
{
  std::vector<double> fractions;
  const Loop::Callback callback = [&](double fraction) { fractions.push_back(fraction); return true; };
  Cell_policy policy({}, 3, 3);
  EXPECT_TRUE(Loop(policy, callback).run());
  EXPECT_EQ(policy.record, (Record{ "begin 3", "find 3", "end 3", "last? 3" }));
  EXPECT_EQ(fractions, std::vector<double>(1, 1.));
}

TEST(Completion_loop, Progress_never_falls_and_ends_with_one)
{
  for(const std::size_t first : { 0u, 4u })
  {
    std::vector<Cell> cells = first == 0 ? random_cells(7) : cells_of_three_levels();
    const std::size_t invalid =
      std::size_t(std::count_if(cells.begin(), cells.end(), [](const Cell& c) { return !c.is_valid; }));
    std::vector<double> fractions;
    const Loop::Callback callback = [&](double fraction) { fractions.push_back(fraction); return true; };
    Cell_policy policy(cells, first, first == 0 ? 0 : 6);
    EXPECT_TRUE(Loop(policy, callback).run());
    ASSERT_EQ(fractions.size(), invalid + 1);   // before each target, skipped or not, and at the end
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.front(), 0.);
    EXPECT_LT(fractions[fractions.size() - 2], 1.);
    EXPECT_EQ(fractions.back(), 1.);
  }
}

TEST(Completion_loop, A_callback_that_says_no_stops_it_at_once)
{
  // how long the record is whenever the callback is called
  std::vector<std::size_t> lengths;
  Cell_policy whole(cells_of_three_levels(), 4, 6);
  const Loop::Callback observe = [&](double) { lengths.push_back(whole.record.size()); return true; };
  EXPECT_TRUE(Loop(whole, observe).run());
  ASSERT_EQ(lengths.size(), 7u);

  for(std::size_t last_call = 1; last_call <= lengths.size(); ++last_call)
  {
    std::size_t calls = 0;
    Cell_policy policy(cells_of_three_levels(), 4, 6);
    const Loop::Callback stop = [&](double) { return ++calls < last_call; };
    EXPECT_FALSE(Loop(policy, stop).run());
    EXPECT_EQ(calls, last_call);
    const std::ptrdiff_t length = std::ptrdiff_t(lengths[last_call - 1]);
    EXPECT_EQ(policy.record, Record(whole.record.begin(), whole.record.begin() + length));
  }
}

} // namespace test_completion_loop
