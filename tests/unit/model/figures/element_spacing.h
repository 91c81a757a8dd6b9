#pragma once

#include "model/figures/distance.h"

namespace figure_testing {

/// The spacing between two elements, over all their pieces; nothing if one of them covers nothing, or beyond `limit`.
inline std::optional<model::Spacing> spacingBetween(const model::Document& document, model::ElementId a,
                                                    model::ElementId b,
                                                    double limit = std::numeric_limits<double>::infinity()) {
    model::FigureTable figuresA;
    model::FigureTable figuresB;
    figuresA.add(document, a);
    figuresB.add(document, b);
    return model::spacingBetween(figuresA, figuresB, limit);
}

}  // namespace figure_testing
