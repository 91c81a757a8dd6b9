#pragma once

#include "ui/workspace/feature.h"

namespace ui {

/// The stackup panel. Thicknesses are edited on the undo history; each edit is worked into a document with other
/// heights and saved in the session file beside the job, which itself is never written to. Thicknesses that were given
/// for one time only (model::OpenRequest::thicknesses) stay out of the file until the user edits them.
void addStackup(FeatureContext& context);

}  // namespace ui
