#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/kicad/canvas.h"
#include "model/formats/kicad/text/text_strokes.h"
#include "model/formats/kicad/text/tree.h"

namespace model::kicad {

/// The value of a variable of a text, ${…}; none if there is none of that name.
using Variables = std::function<std::optional<std::string>(std::string_view name)>;

/// The text of an item as it is drawn: with the values of ${…}, ${LAYER} that of the item's layer, and with bars as
/// ~{CS} where a board of before KiCad 6 has ~CS~. Variables without a value stay as they are written and are reported.
[[nodiscard]] std::string shownText(Canvas& canvas, const Item& item, std::string_view text,
                                    const Variables& variables);

/// A text of KiCad where it lies: (at …), (effects …), (layer …), (render_cache …).
struct TextPlace {
    Item item;                  ///< holds all of these
    std::string text;           ///< as it is drawn, lines separated by \n
    Frame frame;                ///< of (at …); its angle is the board's, not the footprint's
    bool isUpright = false;     ///< of a footprint: turned by half a turn where it would stand on its head
    std::vector<PointD> box{};  ///< what a knockout text is cut out of, on the board; empty: the box around the text
};

/// What (effects …) of an item says; what it leaves out is as KiCad takes it.
[[nodiscard]] TextStyle styleOf(const Item& item);

/// Of texts and fields of footprints: are they not drawn? (hide yes), hide, (effects … hide). Of all other texts KiCad
/// ignores the word: it draws and plots them.
[[nodiscard]] bool isHidden(const Item& item);

/// Draws it: the polygons that KiCad keeps of outline fonts, else strokes of KiCad's own font, as a group of features;
/// that a text is in another font and has no polygons is reported. A knockout text is a box without its characters,
/// strokes or polygons.
void drawText(Canvas& canvas, const TextPlace& place, const Origin& origin);

}  // namespace model::kicad
