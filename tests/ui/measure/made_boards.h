#pragma once

#include "tests/ui/window_fixture.h"
#include "tests/unit/model/measure/measure_fixture.h"

/// Boards worked out by hand, to be measured in the window.
namespace measuring {

/// Net N: a pad at (0, 0), a track to a via at (6, 0) and on at the bottom to a pad at (6, 4). Net M: a bent track, a
/// disc on top and one on the inner layer. And an arc, a disc and a stroke without width of no net. In mm.
inline std::shared_ptr<const model::Document> madeBoard() {
    model::DocumentBuilder builder;
    addLayers(builder);
    const model::NetId n = builder.addNet("N");
    const model::NetId m = builder.addNet("M");
    builder.beginLayer(model::LayerId{Top});
    builder.addCircle({{0, 0}, kMm, 0}, of(n, model::kPad));
    builder.addLine({{0, 0}, {6 * kMm, 0}, 200'000, 0}, of(n));
    builder.addCircle({{6 * kMm, 0}, kMm, 0}, of(n, model::kPad));
    builder.addLine({{0, 3 * kMm}, {3 * kMm, 3 * kMm}, 400'000, 0}, of(m));
    builder.addLine({{3 * kMm, 3 * kMm}, {5 * kMm, 5 * kMm}, 400'000, 0}, of(m));
    builder.addCircle({{-3 * kMm, 0}, kMm, 0}, of(m, model::kPad));
    builder.addCircle({{0, 6 * kMm}, kMm, 0}, {});
    builder.addArc({model::PathNode{{10 * kMm, 0}, {10 * kMm - 1'500'000, 0}, model::EdgeKind::ArcCounterClockwise},
                    {10 * kMm - 1'500'000, 1'500'000},
                    200'000},
                   {});
    builder.addLine({{8 * kMm, 5 * kMm}, {11 * kMm, 5 * kMm}, 0, 0}, {});
    builder.beginLayer(model::LayerId{Inner});
    builder.addCircle({{-3 * kMm, 4 * kMm}, kMm, 0}, of(m, model::kPad));
    builder.beginLayer(model::LayerId{Bottom});
    builder.addLine({{6 * kMm, 0}, {6 * kMm, 4 * kMm}, 200'000, 0}, of(n));
    builder.addCircle({{6 * kMm, 4 * kMm}, kMm, 0}, of(n, model::kPad));
    builder.beginLayer(model::LayerId{Drill});
    builder.addCircle({{6 * kMm, 0}, 400'000, 300'000}, of(n, model::kHole | model::kPlated | model::kVia));
    builder.beginLayer(model::LayerId{Drawing});
    builder.addCircle({{-3 * kMm, 6 * kMm}, kMm, 0}, {});
    return builder.finish();
}

/// A track of 2 mm width that lies over a corner of the board.
inline std::shared_ptr<const model::Document> boardUnderACorner() {
    model::DocumentBuilder builder;
    addLayers(builder);
    const model::NetId n = builder.addNet("N");
    builder.beginLayer(model::LayerId{Top});
    builder.addLine({{0, 5 * kMm}, {6 * kMm, 5 * kMm}, 2 * kMm, 0}, of(n));
    builder.setProfile(builder.addShape(rectangle({3 * kMm, 5'500'000}, {20 * kMm, 20 * kMm})));
    return builder.finish();
}

/// Pads around a hole, the one on the inner layer smaller; and one on top alone, beside them.
inline std::shared_ptr<const model::Document> boardWithAHole() {
    model::DocumentBuilder builder;
    addLayers(builder);
    const model::NetId n = builder.addNet("N");
    builder.beginLayer(model::LayerId{Top});
    builder.addCircle({{0, 0}, 2 * kMm, 0}, of(n, model::kPad));
    builder.addCircle({{4 * kMm, 0}, 2 * kMm, 0}, of(builder.addNet("M"), model::kPad));
    builder.beginLayer(model::LayerId{Inner});
    builder.addCircle({{0, 0}, kMm, 0}, of(n, model::kPad));
    builder.beginLayer(model::LayerId{Drill});
    builder.addCircle({{0, 0}, 400'000, 300'000}, of(n, model::kHole | model::kPlated));
    return builder.finish();
}

/// A plane with a track of its net on top, and a pad of another net beneath, at the bottom.
inline std::shared_ptr<const model::Document> boardWithAPlane() {
    model::DocumentBuilder builder;
    addLayers(builder);
    const model::NetId ground = builder.addNet("G");
    builder.beginLayer(model::LayerId{Top});
    builder.addCircle({{0, 0}, 8 * kMm, 0}, of(ground));
    builder.addLine({{-2 * kMm, 0}, {-kMm, 0}, 200'000, 0}, of(ground));
    builder.beginLayer(model::LayerId{Bottom});
    builder.addCircle({{kMm, 0}, kMm, 0}, of(builder.addNet("N"), model::kPad));
    return builder.finish();
}

inline base::Result<ui::LoadedBoard> loadMade(const model::OpenRequest& request, base::Progress& progress) {
    ui::LoadedBoard board;
    board.request = request;
    board.request.noSession = true;
    board.document = request.path == "corner"  ? boardUnderACorner()
                     : request.path == "hole"  ? boardWithAHole()
                     : request.path == "plane" ? boardWithAPlane()
                                               : madeBoard();
    auto shapes = render::buildBoardModel(*board.document, {}, progress);
    if (!shapes) {
        return shapes.error();
    }
    board.model = std::make_shared<const render::BoardModel>(std::move(*shapes));
    board.index = indexed(board.document);
    return board;
}

}  // namespace measuring
