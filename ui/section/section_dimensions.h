#pragma once

#include <QCoreApplication>
#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include "model/measure/section_dimension.h"
#include "ui/common/display_units.h"

namespace ui {

/// What is measured in a section: distances, each between two locations one after the other.
class SectionDimensions {
    Q_DECLARE_TR_FUNCTIONS(ui::SectionDimensions)
public:
    void set(std::vector<model::SectionDimension> all) {
        m_all = std::move(all);
        m_from.reset();
    }
    /// The first location of a distance, or the second one: then it is added, and true.
    bool add(const model::SectionPosition& location);
    /// Gives the first location up. False if there is none.
    bool giveUp();
    void removeLast();

    [[nodiscard]] const std::vector<model::SectionDimension>& all() const { return m_all; }
    [[nodiscard]] const std::optional<model::SectionPosition>& from() const { return m_from; }

private:
    std::vector<model::SectionDimension> m_all;
    std::optional<model::SectionPosition> m_from;
};

/// In the unit of the window and the other one: "0.2 mm (7.87 mil)"; of slanting ones how far they go in either
/// direction too.
[[nodiscard]] QString dimensionText(const model::SectionDimension& dimension, LengthUnit unit);

}  // namespace ui
