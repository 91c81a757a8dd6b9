#pragma once

#include <memory>

#include "model/board/document_builder.h"

/// A small board made by hand: two copper layers, a document layer, and an outline that Copperscope added itself.
inline std::shared_ptr<const model::Document> sampleDocument() {
    using namespace model;
    DocumentBuilder builder;
    const auto addLayer = [&](const char* name, LayerType type, LayerSide side, bool isSynthetic) {
        Layer layer;
        layer.name = name;
        layer.type = type;
        layer.side = side;
        layer.isSynthetic = isSynthetic;
        layer.thickness = type == LayerType::Signal ? 35000 : 0;
        return builder.addLayer(layer);
    };
    const LayerId top = addLayer("top", LayerType::Signal, LayerSide::Top, false);
    const LayerId bottom = addLayer("bottom", LayerType::Signal, LayerSide::Bottom, false);
    const LayerId notes = addLayer("notes", LayerType::Document, LayerSide::None, false);
    const LayerId outline = addLayer("(outline)", LayerType::Profile, LayerSide::None, true);

    builder.beginLayer(top);
    for (int i = 0; i < 1200; ++i) {
        builder.addLine({{0, i * 1000}, {1000000, i * 1000}, 100000, 0}, {});
    }
    builder.addCircle({{0, 0}, 500000, 0}, {});
    builder.beginLayer(bottom);
    builder.addCircle({{0, 0}, 500000, 0}, {});
    builder.addCircle({{2000000, 0}, 500000, 0}, {});
    builder.beginLayer(notes);
    builder.beginLayer(outline);
    builder.addLine({{0, 0}, {10000000, 0}, 100000, 0}, {});
    builder.layer(top).featureCount = 1300;
    builder.layer(bottom).featureCount = 2;

    builder.diagnostics().report(Severity::Info, "matrix/matrix", 0,
                                 "No thickness for the copper layers: 35 µm assumed");
    builder.diagnostics().report(Severity::Warning, "steps/pcb/layers/top/features", 17, "Text record not drawn");
    builder.diagnostics().report(Severity::Warning, "steps/pcb/layers/top/features", 19, "Text record not drawn");
    builder.diagnostics().report(Severity::Error, "steps/pcb/layers/bottom/features", 4, "Symbol is defined nowhere");
    return builder.finish();
}
