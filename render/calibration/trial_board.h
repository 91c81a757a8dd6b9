#pragma once

#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/generate/layout.h"
#include "render/modelling/board_model.h"
#include "render/scene/layer_style.h"

namespace render {

/// A made-up board, as a user would see it.
struct TrialBoard {
    BoardModel model;
    std::vector<LayerStyle> styles;
};

/// Writes the job in memory and reads it as any other. Errors: Cancelled.
[[nodiscard]] base::Result<TrialBoard> makeTrialBoard(const model::generate::Wanted& wanted, base::Progress& progress);

}  // namespace render
