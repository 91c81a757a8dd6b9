#include "model/formats/kicad/vias.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/holes.h"
#include "model/formats/kicad/back_drills.h"
#include "model/formats/kicad/post_machining.h"
#include "model/formats/kicad/text/values.h"

namespace model::kicad {

namespace {

using formats::kNoRow;

/// On which sides solder mask covers a via: what it says itself, else the board.
std::array<bool, 2> tentingOf(const Item& via, std::array<bool, 2> board) {
    const Item tenting = via.find("tenting");
    if (!tenting.isThere()) {
        return board;
    }
    std::array<bool, 2> sides{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string_view side = i == 0 ? "front" : "back";
        const Item list = tenting.find(side);
        sides[i] = list.isThere() && list.word(1) != "yes" && list.word(1) != "no" ? board[i] : tenting.isSet(side);
    }
    return sides;
}

double viaSizeOn(const Item& via, const std::string& layer) {
    const Item stack = via.find("padstack");
    for (const Item item : stack) {
        const bool isInner = item.word(1) == "Inner" && layer.starts_with("In");
        if (item.head() == "layer" && (item.word(1) == layer || isInner)) {
            return length(item, "size", length(via, "size"));
        }
    }
    return length(via, "size");
}

void openMask(Canvas& canvas, const Item& via, const Origin& origin, PointD at, const std::vector<std::int32_t>& span) {
    const BoardLayers& layers = canvas.layers();
    const std::array<bool, 2> isTented = tentingOf(via, canvas.settings().isViaTented);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::int32_t mask = layers.row(i == 0 ? "F.Mask" : "B.Mask");
        const bool reaches =
            (i == 0 ? span.front() : span.back()) == (i == 0 ? layers.copper().front() : layers.copper().back());
        if (!isTented[i] && mask != kNoRow && reaches) {
            const double width = viaSizeOn(via, i == 0 ? "F.Cu" : "B.Cu") + 2.0 * canvas.settings().maskMargin;
            canvas.drawPad(mask, origin, canvas.pen(std::max(width, 0.0)), at, 0.0);
        }
    }
}

constexpr std::array<const char*, 3> kPartialTypes = {"blind", "buried", kMicroviaType};

/// The copper that a via passes. One without a type goes through the board whatever layers it names, as in KiCad.
std::vector<std::int32_t> spanOf(Canvas& canvas, const Item& via) {
    const BoardLayers& layers = canvas.layers();
    const Item names = via.find("layers");
    std::vector<std::int32_t> span = layers.span(layers.row(names.word(1)), layers.row(names.word(2)));
    const bool isPartial = std::ranges::any_of(kPartialTypes, [&](const char* type) { return via.hasWord(type); });
    if (isPartial || span.size() == layers.copper().size()) {
        return span;
    }
    canvas.report(Severity::Info, via.line(),
                  "a via names other layers than the outer ones, but is not called blind or buried; it goes through "
                  "the whole board");
    return layers.copper();
}

/// A via that is called a microvia and does not end on the next layer counts as what it is.
void reportMicrovia(Canvas& canvas, const Item& via, const std::vector<std::int32_t>& span) {
    const BoardLayers& layers = canvas.layers();
    const bool isThrough = span.size() == layers.copper().size();
    if (span.size() != 2 || isThrough) {
        canvas.report(
            Severity::Info, via.line(),
            "a via is called a microvia, but " +
                std::string(isThrough ? "goes through the whole board" : "passes more than two copper layers") +
                "; it counts as a drilled one");
    }
}

}  // namespace

void reportProtection(Canvas& canvas, const Item& item) {
    for (const char* kind : {"covering", "plugging", "filling", "capping"}) {
        const Item list = item.find(kind);
        const bool isSaid = list.word(1) == "yes" || list.hasWord("front") || list.hasWord("back") ||
                            list.find("front").word(1) == "yes" || list.find("back").word(1) == "yes";
        if (isSaid) {
            canvas.report(Severity::Info, list.line(),
                          "what is said of vias as '" + std::string(kind) + "' is not read");
        }
    }
}

bool removesUnused(const Item& item) {
    return item.isSet("remove_unused_layers") || item.isSet("remove_unused_layer");
}

bool keepsEnds(const Item& item) {
    return item.isSet("keep_end_layers");
}

void drawVia(Canvas& canvas, UnusedPads& unused, const Item& via) {
    const std::optional<PointD> at = point(via, "at");
    const double size = length(via, "size");
    if (!at || size <= 0.0) {
        canvas.report(Severity::Warning, via.line(), "a via has no place or size; it was left out");
        return;
    }
    BoardLayers& layers = canvas.layers();
    const std::vector<std::int32_t> span = spanOf(canvas, via);
    if (span.empty()) {
        return;
    }
    Origin origin;
    origin.line = via.line();
    origin.net = canvas.netOf(via);
    origin.subnet = SubnetKind::Via;
    origin.plating = Plating::Via;
    for (const char* type : kPartialTypes) {
        if (via.hasWord(type)) {
            origin.attributes = canvas.attributes({{kViaType, type}});
        }
    }
    if (via.hasWord(kMicroviaType)) {
        reportMicrovia(canvas, via, span);
    }
    double drill = length(via, "drill", canvas.settings().viaDrill);
    const bool namesDrill = drill > 0.0;
    drill = namesDrill ? drill : size / 2.0;
    UnusedPads::Owner owner{span, origin.net, formats::kNoRow, *at, 0.0, {}, size / 2.0, drill / 2.0};
    owner.waits = removesUnused(via);
    owner.keepsEnds = keepsEnds(via);
    const std::size_t number = unused.add(std::move(owner));
    const Item connected = via.find("zone_layer_connections");
    for (const std::int32_t row : span) {
        const double width = viaSizeOn(via, layers.nameOf(row));
        const bool isEnd = row == span.front() || row == span.back();
        if (!isEnd && via.isSet("start_end_only")) {
            continue;
        }
        const bool isKept = isEnd && keepsEnds(via);
        if (removesUnused(via) && !isKept && !connected.hasWord(layers.nameOf(row))) {
            unused.add({row, origin, canvas.pen(width), *at, 0.0, width / 2.0, number});
        } else {
            canvas.drawPad(row, origin, canvas.pen(width), *at, 0.0);
        }
    }
    openMask(canvas, via, origin, *at, span);
    reportProtection(canvas, via);
    if (!namesDrill) {
        canvas.report(Severity::Warning, via.line(), "a via names no drill; half of its pad was taken");
    }
    const std::int32_t row = layers.drills(span.front(), span.back(), true, canvas.job());
    canvas.drawPad(row, origin, canvas.pen(drill), *at, 0.0);
    drawBackDrills(canvas, via, origin, *at);
    drawPostMachining(canvas, via, origin, *at, drill);
}

}  // namespace model::kicad
