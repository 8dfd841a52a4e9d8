/**
 * @class   vtkBackgroundUpdate
 * @brief   update a filter, reader or writer on another thread, with progress, abort and messages
 *
 * Start() updates an algorithm (a filter, reader or writer) on a new thread, and returns
 * immediately. The calling thread can then show progress, process events, and abort the update. In
 * Python, the new thread does not hold the global interpreter lock. Other Python threads continue
 * to run, and Ctrl-C is processed. The functions of the Python package conformalsom run all filters
 * by this class.
 *
 * While the update runs, do not use the algorithm, its inputs and its outputs on any other thread.
 * If the algorithm or an algorithm upstream has observers, the observers run on the new thread.
 * Several objects of this class can run at the same time, with separate algorithms.
 *
 * Errors and warnings of the algorithm and of its executive (the object that runs the algorithm in
 * the pipeline) are kept and not printed. With several processes (MPI), use Update() of the
 * algorithm instead, since MPI may permit calls only from the main thread.
 *
 * Own construction: the class contains no mathematics.
 *
 * @sa
 * vtkConformalSOM vtkCurvedSeamlessSurface
 */

#ifndef vtkBackgroundUpdate_h
#define vtkBackgroundUpdate_h

#include "vtkFiltersConformalModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for std::unique_ptr
#include <string> // for messages

class vtkAlgorithm;

class VTKFILTERSCONFORMAL_EXPORT vtkBackgroundUpdate : public vtkObject
{
public:
  static vtkBackgroundUpdate* New();
  vtkTypeMacro(vtkBackgroundUpdate, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Begin to update an algorithm on a new thread. A writer writes its file. If an earlier update of
   * this object still runs, an error is reported, and the function returns false.
   */
  bool Start(vtkAlgorithm* algorithm);

  /**
   * Return whether the update runs.
   */
  bool IsRunning() const;

  /**
   * Abort the update at its next progress event. The function returns immediately; the update runs
   * until that event. The output of an aborted filter is empty.
   */
  void Abort();

  /**
   * Return after the update has ended. In Python, this function holds the global interpreter lock.
   * To keep other threads running, call this function only after IsRunning() has returned false.
   */
  void Wait();

  /**
   * Return the completed fraction of the update, in [0, 1].
   */
  double GetProgress() const;

  /**
   * Return the number of errors that the algorithm and its executive reported. Call this function
   * and the following ones after the update has ended.
   */
  int GetNumberOfErrors() const;

  /**
   * Return an error message, with the file and line of the source code that reported it. Messages
   * are numbered from 0. For other numbers, the message is empty.
   */
  std::string GetError(int index) const;

  /**
   * Return the number of warnings that the algorithm and its executive reported.
   */
  int GetNumberOfWarnings() const;

  /**
   * Return a warning, with the file and line of the source code that reported it. Warnings are
   * numbered from 0. For other numbers, the text is empty.
   */
  std::string GetWarning(int index) const;

protected:
  vtkBackgroundUpdate();
  ~vtkBackgroundUpdate() override;

private:
  vtkBackgroundUpdate(const vtkBackgroundUpdate&) = delete;
  void operator=(const vtkBackgroundUpdate&) = delete;

  struct State;
  std::unique_ptr<State> Current;
};

#endif
