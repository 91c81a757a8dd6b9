#include "model/formats/odb/message_locations.h"

#include <algorithm>

#include "model/formats/steps/elements_of_feature.h"

namespace model::odb {

namespace {

/// The record on this line, or the surface around it; `features.size()` if there is none.
std::size_t recordAt(const FeatureFile& file, std::uint32_t line) {
    const auto after = std::ranges::upper_bound(file.features, line, {}, &Feature::line);
    if (after == file.features.begin()) {
        return file.features.size();
    }
    const Feature& record = *(after - 1);
    const bool isInSurface = record.kind == FeatureKind::Surface && line <= file.surfaceEnds[record.index];
    const bool isIt = record.line == line || isInSurface;
    return isIt ? static_cast<std::size_t>(after - 1 - file.features.begin()) : file.features.size();
}

std::optional<Point> locationOf(const FeatureFile& file, std::size_t record) {
    const Feature& feature = file.features[record];
    if (feature.kind == FeatureKind::Bad) {
        return std::nullopt;  // what could not be read may be the coordinates
    }
    if (feature.kind != FeatureKind::Surface) {
        return feature.a;
    }
    const Box& box = file.surfaces.shapes[feature.index].box;
    return box.isEmpty() ? std::nullopt : std::optional(box.middle());
}

std::optional<Point> locationOf(const std::vector<PlacedComponent>& components, std::uint32_t line) {
    const auto after = std::ranges::upper_bound(components, line, {}, &PlacedComponent::line);
    return after == components.begin() ? std::nullopt : std::optional((after - 1)->position);
}

}  // namespace

void locateMessages(DocumentBuilder& builder, const LayerTable& layers, const StepData& step) {
    Diagnostics& messages = builder.diagnostics();
    for (std::size_t i = 0; i < messages.entries().size(); ++i) {
        const Diagnostic& message = messages.entries()[i];
        for (std::size_t row = 0; row < step.layers.size() && message.line > 0 && !message.element.isValid(); ++row) {
            const StepLayer& layer = step.layers[row];
            const FeatureFile& file = layer.features.value;
            if (layer.components.isPresent() && message.file == layer.components.path) {
                messages.locate(i, {}, locationOf(layer.components.value, message.line));
            } else if (layer.features.isPresent() && message.file == layer.features.path) {
                const std::size_t record = recordAt(file, message.line);
                if (record < file.features.size()) {
                    const std::vector<ElementId> made = formats::elementsOf(builder.soFar(), layers.id(row), record);
                    const ElementId element = made.empty() ? ElementId{} : made.front();
                    messages.locate(i, element, element.isValid() ? std::nullopt : locationOf(file, record));
                }
            }
        }
    }
}

}  // namespace model::odb
