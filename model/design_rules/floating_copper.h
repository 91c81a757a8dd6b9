#pragma once

#include "model/design_rules/rule_context.h"

namespace model {

/// RuleKind::FloatingCopper, on all layers at once: copper that touches, directly or by other copper and plated holes,
/// neither a pad nor a plated hole. One finding per piece, on its first layer. Texts are left out and counted in a
/// note. Errors: Cancelled.
[[nodiscard]] base::Status checkFloatingCopper(RuleContext& context);

}  // namespace model
