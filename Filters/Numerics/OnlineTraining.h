/// The CSM Learning Algorithm, step by step; a part of trainConformalSOM.

#ifndef ConformalOnlineTraining_h
#define ConformalOnlineTraining_h

#include "ConformalSOM.h"

namespace conformal
{
/// Steps 1 to 5 of \cite Liou2008, section 2, on a network given; weights in the samples' unit
/// (max radius 1).
ConformalSOMResult trainOnline(const TrainingSamples& samples, const GeodesicSphere& network,
  const ConformalSOMOptions& options, const Progress& progress);
}

#endif
