#pragma once

#include <QCoreApplication>
#include <QString>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "model/board/copies.h"
#include "model/index/attributes.h"
#include "ui/common/display_units.h"

namespace ui {

/// Those with the same fit are listed in this order.
enum class FoundKind : std::uint8_t { Location, Component, Pin, Net, Layer, Attribute };

/// Something on the board that a text names.
struct Found {
    FoundKind kind = FoundKind::Net;
    std::uint32_t row = 0;   ///< of the kind's table in the document of the step; of BoardSearch::attribute; of
                             ///< locations 1 if Y was taken to count downwards
    std::uint32_t step = 0;  ///< row of model::StepTree::steps; of layers and locations the board itself
    base::PointD location;   ///< of locations, nm in the board's coordinates
};

/// Finds nets, components, pins, attributes, layers and locations by what people type: part of a name in any case,
/// "U1.5" or "U1-5" for a pin, a value or a name for an attribute, "12.5, 30 mm" for a location; in the board and in
/// all the steps placed on it. Names are looked through as they lie in the document; of attributes each value is listed
/// once, in the background when the board is set. With * for any letters and ? for one, the text is to fit all of a
/// name.
class BoardSearch {
    Q_DECLARE_TR_FUNCTIONS(ui::BoardSearch)
public:
    /// Null for no board.
    void setBoard(std::shared_ptr<const model::Document> board);
    /// Locations first, then names that are the text, that begin with it, that hold it, short ones before long ones;
    /// attributes in the same order behind them, but for texts on the board that only name a component or pin.
    /// Coordinates without a unit are in `unit`; beside the board they may be those of a program that counts Y
    /// downwards, which is offered first where it is on the board.
    [[nodiscard]] std::vector<Found> find(const QString& text, LengthUnit unit, std::size_t most) const;
    [[nodiscard]] const model::AttributeValue& attribute(const Found& found) const {
        return m_attributes.get()[found.step][found.row];
    }
    /// Its name; a location in `unit`.
    [[nodiscard]] QString titleOf(const Found& found, LengthUnit unit) const;
    /// "Net, 5 elements", "Component, 0603 on the top side": what it is, and in which step if not in the board's own.
    [[nodiscard]] QString detailOf(const Found& found) const;

private:
    [[nodiscard]] const model::Document& stepOf(const Found& found) const { return *m_steps[found.step]; }
    [[nodiscard]] QString whatIs(const Found& found) const;

    using AttributesOfSteps = std::vector<std::vector<model::AttributeValue>>;

    std::shared_ptr<const model::Document> m_board;
    std::vector<const model::Document*> m_steps;         ///< rows of model::StepTree::steps
    std::shared_future<AttributesOfSteps> m_attributes;  ///< of each step; of no board none
};

/// Two numbers, with or without a comma and a unit behind each or the last one (mm, mil, in, um); in nm.
[[nodiscard]] std::optional<base::PointD> parsePlace(const QString& text, LengthUnit unit);

}  // namespace ui
