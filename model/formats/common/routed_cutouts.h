#pragma once

#include "model/board/document_builder.h"

namespace model::formats {

/// A cutter that goes all around a piece of the board cuts it loose. Takes such pieces out of the outline: what closed
/// non-plated paths on layers of routed slots enclose, if they pass all copper, and if no copper and no other step lies
/// there. A path around half of the board or more leaves that half, and cuts nothing out. Each is reported.
///
/// To be called when the profile and all positive layers are there, before what depends on the outline.
void takeOutRouted(DocumentBuilder& builder);

}  // namespace model::formats
