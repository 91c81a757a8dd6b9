#pragma once

#include <optional>
#include <string>

#include "model/measure/measurement.h"
#include "model/measure/net_path.h"
#include "ui/measure/measuring_cursor.h"
#include "ui/workspace/workspace.h"

/// From what was clicked to what is saved.
namespace ui {

[[nodiscard]] model::MeasuredEnd endOf(const model::BoardIndex& index, const Caught& caught);

/// In the plane if both were clicked in a plan.
[[nodiscard]] model::Measurement pointToPoint(const model::BoardIndex& index, const Caught& from, const Caught& to);
/// Of two elements on one layer, if need be of other pads of the holes through them, or through the stackup; or of one
/// and the board's edge; of a hole and the copper around it the annular ring. Errors: BadUsage where there is no
/// distance, and why.
[[nodiscard]] base::Result<model::Measurement> edgeToEdge(const model::BoardIndex& index, const Caught& a,
                                                          const Caught& b);
/// The layer and the distance in nm where the nets of two elements come closer to each other than `distance` on one
/// layer. Nothing if they do not, have no net or one net, or are too large to be looked through at once.
struct CloserNets {
    std::string layer;  ///< empty: between holes
    double distance = 0.0;
};
[[nodiscard]] std::optional<CloserNets> netsCloserThan(const model::BoardIndex& index, double distance,
                                                       model::BoardElement a, model::BoardElement b);
/// A spacing that was found, on a layer or through the stackup.
[[nodiscard]] model::Measurement spacingOn(const model::BoardIndex& index, const ShownSpacing& spacing);
[[nodiscard]] model::Measurement angleAt(const model::BoardIndex& index, const Caught& corner, const Caught& from,
                                         const Caught& to);
/// Of the lines of two Catch::Straight, seen from where they cross to where they were clicked. Errors: BadUsage for
/// parallel ones.
[[nodiscard]] base::Result<model::Measurement> angleOfLines(const model::BoardIndex& index, const Caught& a,
                                                            const Caught& b);
/// Of a Catch::Round.
[[nodiscard]] model::Measurement radiusOf(const model::BoardIndex& index, const Caught& caught);
/// Errors: BadUsage if the ends are one location.
[[nodiscard]] base::Result<model::Measurement> lengthAlong(const model::BoardIndex& index, const Caught& from,
                                                           const Caught& to, const model::NetPath& path);

/// All locations at which a measurement is drawn, and on which layers.
[[nodiscard]] std::vector<std::pair<base::PointD, std::string>> locationsOf(const model::Measurement& measurement);
/// Where a length along a net begins or ends: pads and holes as they are, else the location on its layer.
[[nodiscard]] model::MeasureItem pathEndOf(const model::BoardIndex& index, const Caught& caught);

}  // namespace ui
