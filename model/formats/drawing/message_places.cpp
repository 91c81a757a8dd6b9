#include "model/formats/drawing/message_places.h"

#include <algorithm>
#include <map>
#include <string_view>

namespace model::formats {

namespace {

/// The first element of every line of the files that messages are about.
class ElementsOfLines {
public:
    explicit ElementsOfLines(const Document& document) : m_document(document) {}

    [[nodiscard]] ElementId find(std::string_view file, std::uint32_t line) {
        const auto [location, isNew] = m_files.try_emplace(file);
        if (isNew) {
            location->second = linesOf(file);
        }
        const std::vector<Line>& lines = location->second;
        const auto found = std::ranges::lower_bound(lines, line, {}, &Line::first);
        return found != lines.end() && found->first == line ? found->second : ElementId{};
    }

private:
    using Line = std::pair<std::uint32_t, ElementId>;

    [[nodiscard]] std::vector<Line> linesOf(std::string_view file) const {
        std::vector<Line> lines;
        for (const Layer& layer : m_document.layers) {
            for (std::uint32_t i = 0; i < layer.elements.count && layer.file == file; ++i) {
                const ElementId id{std::size_t{layer.elements.first} + i};
                lines.emplace_back(m_document.elements.line[id.row()], id);
            }
        }
        std::ranges::sort(lines);
        return lines;
    }

    const Document& m_document;
    std::map<std::string_view, std::vector<Line>> m_files;
};

std::optional<Point> componentAt(const DrawnStep& step, std::string_view file, std::uint32_t line) {
    const auto found = std::ranges::find(step.components, line, &DrawnComponent::line);
    const bool isFound = file == step.componentsFile && found != step.components.end();
    return isFound ? std::optional(found->position) : std::nullopt;
}

}  // namespace

void locateMessages(DocumentBuilder& builder, const DrawnStep& step) {
    Diagnostics& messages = builder.diagnostics();
    ElementsOfLines elements(builder.soFar());
    for (std::size_t i = 0; i < messages.entries().size(); ++i) {
        const Diagnostic& message = messages.entries()[i];
        if (message.line == 0 || message.element.isValid() || message.location) {
            continue;
        }
        const std::optional<Point> component = componentAt(step, message.file, message.line);
        const ElementId element = component ? ElementId{} : elements.find(message.file, message.line);
        if (component || element.isValid()) {
            messages.locate(i, element, component);
        }
    }
}

}  // namespace model::formats
