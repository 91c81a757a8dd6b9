#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/shapes/pad_outlines.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// The hole of a pad, in the pad's own frame.
struct PadDrill {
    double width = 0.0;
    double height = 0.0;
    PointD offset;  ///< of the copper from the hole
};

/// (drill 1), (drill oval 1.2 0.6 (offset 0.3 0)). All 0 where there is none.
[[nodiscard]] PadDrill drillOf(const Item& pad);

/// The forms that a pad has on its layers: one, or by its pad stack.
class PadForms {
public:
    struct Form {
        PadForm form;
        PointD offset;
    };

    PadForms(Canvas& canvas, const Item& pad, const PadDrill& drill);

    /// On a layer by its name; those of mask and paste are as the copper of their side.
    [[nodiscard]] const Form& on(const std::string& layer) const;

private:
    std::vector<Form> m_forms;
    std::vector<std::pair<std::string, std::size_t>> m_layers;
    bool m_isFrontInnerBack = true;
};

}  // namespace model::kicad
