#pragma once

#include <QtTest>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/base/parallel.h"
#include "model/board/document_builder.h"
#include "model/design_rules/design_rule_check.h"
#include "tests/unit/model/hand_made.h"

/// What tests of design rules check: a small board made by hand.
namespace rule_board {

/// Flags of an NPTH, and of a plated hole.
inline constexpr int kBare = model::kHole;
inline constexpr int kWall = model::kHole | model::kPlated;

/// Two copper layers, a mask on top, a drill through both.
struct Board {
    model::DocumentBuilder builder;
    model::LayerId mask = hand_made::addLayer(builder, "mask", model::LayerType::SolderMask);
    model::LayerId top = hand_made::addLayer(builder, "top", model::LayerType::Signal);
    model::LayerId bottom = hand_made::addLayer(builder, "bottom", model::LayerType::Signal);
    model::LayerId drill = hand_made::addDrill(builder, top, bottom);
    model::NetId a = builder.addNet("A");
    model::NetId b = builder.addNet("B1");
    std::uint32_t pins = 0;  ///< added by addPart
};

/// Without tolerance: to the nanometre.
[[nodiscard]] inline model::RuleReport check(const model::Document& board, model::RuleTable table) {
    base::Progress progress;
    table.tolerance = 0;
    return *model::checkRules(board, table, progress);
}

[[nodiscard]] inline model::RuleReport check(const model::Document& board, model::RuleKind kind, model::Nm least) {
    return check(board, model::RuleTable{{}, {{kind, least, {}}}});
}

/// One finding below the width, none at it.
inline void verifyNarrowest(const model::Document& board, model::RuleKind kind, model::Nm width) {
    QVERIFY(check(board, kind, width).isPassed());
    const model::RuleReport broken = check(board, kind, width + 1);
    QCOMPARE(broken.findings.size(), std::size_t{1});
    QCOMPARE(broken.counts.front(), std::size_t{1});
    QVERIFY2(std::abs(broken.findings.front().spacing.distance - width) < 0.001,
             qPrintable(QString::number(broken.findings.front().spacing.distance)));
}

struct PadAt {
    model::NetId net;
    model::Point at;
};

/// A component with pads of 100 um on the layer that was begun, a pin each.
inline void addPart(Board& board, model::Component part, const std::vector<PadAt>& pads) {
    std::vector<model::Pin> pins;
    for (const PadAt& pad : pads) {
        model::Pin pin;
        pin.net = pad.net;
        pin.position = pad.at;
        pin.name = board.builder.string(std::to_string(pins.size() + 1));
        pins.push_back(pin);
    }
    board.builder.addComponent(std::move(part), pins);
    for (const PadAt& pad : pads) {
        model::DocumentBuilder::Origin origin = hand_made::of(pad.net, model::kPad);
        origin.subnet = board.builder.addSubnet({pad.net, model::SubnetKind::PinPads, model::PinId{board.pins++}});
        board.builder.addCircle({pad.at, 100 * hand_made::kUm, 0}, origin);
    }
}

}  // namespace rule_board
