/*!
  \ingroup PkgContextCompletion3Concepts
  \cgalConcept

  The concept `CompletionVisitor` describes what a visitor must provide to be told of the events of
  `CGAL::context_complete()` and of `CGAL::Context_completion_3`. It is given with the named parameter `visitor`.

  All functions are called by the thread that called `CGAL::context_complete()`,
  `CGAL::Context_completion_3::detect_holes()` or `CGAL::Context_completion_3::complete()`. They must not change the
  point set. An exception that is thrown by one of them ends the computation and is passed on, the point set being as it
  was before.

  After a cancellation by the named parameter `callback` no further event follows.

  \cgalHasModelsBegin
  \cgalHasModels{CGAL::Context_completions_3::Default_completion_visitor}
  \cgalHasModelsEnd

  \sa `CGAL::context_complete()`
  \sa `CGAL::Context_completion_3`
*/
class CompletionVisitor
{
public:
  /// \name Detection
  /// @{

  /// is called before holes are searched among `number_of_points` points.
  void on_detection_begin(std::size_t number_of_points);

  /// is called when `number_of_holes` under-sampled places are known, whether they are to be filled or not.
  void on_detection_end(std::size_t number_of_holes);

  /// @}

  /// \name Completion
  /// @{

  /// is called before the chosen holes are filled, of which `number_of_holes` are not yet completed.
  void on_completion_begin(std::size_t number_of_holes);

  /// is called before the hole of index `hole` is filled. Holes are filled by increasing index.
  void on_hole_begin(std::size_t hole);

  /// is called when the hole of index `hole` has got `number_of_new_points` points, possibly none.
  void on_hole_end(std::size_t hole, std::size_t number_of_new_points);

  /// is called when all chosen holes are completed, by `number_of_new_points` points in this run.
  void on_completion_end(std::size_t number_of_new_points);

  /// @}
};
