#include "debug/Drawing.h"
#include "framework/Description.h"
#include "framework/QueueFill.h"
#include "framework/RepresentationDefinition.h"
#include "framework/Requests.h"

/// What the framework and its tools send each other.
namespace gt {

template const RepresentationType& representation<DebugKeyRequest>();
template const RepresentationType& representation<DebugRequest>();
template const RepresentationType& representation<DescriptionRequest>();
template const RepresentationType& representation<DroppedMessages>();
template const RepresentationType& representation<Drawing>();
template const RepresentationType& representation<GenericDebugData>();
template const RepresentationType& representation<LayoutRequest>();
template const RepresentationType& representation<MessageQueue>();
template const RepresentationType& representation<ModuleTimes>();
template const RepresentationType& representation<ParameterRequest>();
template const RepresentationType& representation<Plot>();
template const RepresentationType& representation<ProcessDescription>();
template const RepresentationType& representation<QueueFillRequest>();
template const RepresentationType& representation<RequestAnswer>();
template const RepresentationType& representation<SolutionRequest>();
template const RepresentationType& representation<StopwatchTime>();
template const RepresentationType& representation<Text>();
template const RepresentationType& representation<ValueRequest>();
template const RepresentationType& representation<WatchRequest>();

}  // namespace gt
