#pragma once

#include "model/board/document_builder.h"
#include "model/formats/drawing/drawn_job.h"

namespace model::formats {

/// Finds what on the board the messages about lines of the job's files speak of, once the step's elements are built:
/// the first element that came out of the line, or else where the component of the line lies.
void locateMessages(DocumentBuilder& builder, const DrawnStep& step);

}  // namespace model::formats
