/// Report the failure of a filter once.
#ifndef GlueFailedRequests_h
#define GlueFailedRequests_h

class vtkAlgorithm;

namespace glue
{
/// Return the value with which a request reports its failure to the pipeline. If the pipeline
/// (vtkExecutive) gets this value, it prints eleven lines about the request, which name neither the
/// input nor the cause. The filter has already reported its error in one message. Therefore, the
/// next message of the pipeline is suppressed if it is about the failed request. Messages are not
/// suppressed if the pipeline has an observer of errors.
/// @return 0
int FailedRequest(vtkAlgorithm* self);
}

#endif
