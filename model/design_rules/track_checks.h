#pragma once

#include "model/design_rules/rule_context.h"

/// Checks of tracks alone.
namespace model {

/// RuleKind::TrackWidth: the narrowest edge of each track; of a square pen what the copper has across it. Necks of
/// planes and of pads drawn as areas are not measured. Strokes of texts, and on boards with nets copper of none, are no
/// tracks: a note counts those that are narrower.
void checkTrackWidths(RuleContext& context, LayerId layer);

/// RuleKind::AcuteAngle: two tracks of a net that meet at less than 90° and leave a notch between them, which etching
/// solution stays in. Where other copper of the net fills the notch, or a track ends before it opens, there is none.
/// One finding per pair of tracks, where they meet. Arcs count with their tangent. Tracks of square pens are
/// not looked at, and are unchecked.
void checkAcuteAngles(RuleContext& context, LayerId layer, const LayerGeometry& copper);

}  // namespace model
