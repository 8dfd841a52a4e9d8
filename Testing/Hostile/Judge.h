// What to think of what a filter did.
#ifndef HostileJudge_h
#define HostileJudge_h

#include "Case.h"

#include <set>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace hostile
{
/// Errors and warnings of all of VTK, from when it was made on; nothing is printed. One at a time.
class Messages
{
public:
  Messages();
  ~Messages();
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;
  int errors() const;
  int warnings() const;
  std::string first() const; ///< of the errors, or else of the warnings
};

/// Arrays by which a filter passes on what it was given; what is in them is not its doing.
std::set<const void*> ArraysOf(vtkDataObject* data);

/// What is wrong with the outputs of a filter; Fine if nothing is. Empty ones are fine.
/// @param[in] given  arrays whose values need not be finite
Outcome JudgeData(vtkDataObject* data, const std::set<const void*>& given);

/// Whether the triangles of a surface are a closed, oriented one of Euler number 2.
bool IsClosedSphere(vtkPolyData* surface);

/// The whole of it: an error comes with empty outputs, a result is whole and finite, and nothing
/// is empty without a word.
/// @param[in] isClosed  whether the first output must be a closed surface of genus zero
Outcome JudgeFilter(vtkAlgorithm* filter, const std::vector<vtkDataObject*>& inputs,
  const Messages& messages, bool isClosed);
}

#endif
