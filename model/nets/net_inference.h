#pragma once

#include <memory>
#include <string_view>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"

namespace model {

/// The same board with nets found by following its copper, instead of those of the job: one net per connected set of
/// copper, named after the netlist point it carries, else $1, $2, … in document order. Sets with the same point name
/// are one net. A set that carries points of several names is divided among them: the pads at the points have their own
/// names, and the copper between them that of the nearest, so that checkNets finds the short. Pins get the net of the
/// copper below them. Subnets, which belong to the job's nets, are gone. Steps that the board places get nets of their
/// own. Reported: copper that carries points of several names, areas whose islands are in several nets (an element has
/// one). Errors: Cancelled.
[[nodiscard]] base::Result<std::shared_ptr<const Document>> withInferredNets(const Document& document,
                                                                             base::Progress& progress);

/// "$7", as withInferredNets calls a net without a netlist point.
[[nodiscard]] bool isNumberedNet(std::string_view name);
/// Are all nets of a document such ones? Then nothing but its copper says what belongs together: checkNets has no
/// shorts or opens to find.
[[nodiscard]] bool areNetsOfCopper(const Document& document);

}  // namespace model
