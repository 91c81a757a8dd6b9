#pragma once

#include <QColor>
#include <optional>

#include "ui/common/table_model.h"
#include "ui/element/element_facts.h"

namespace ui {

/// To what a fact of an element, or of a net, leads on.
enum class FactLink { Layer, Net, Pin, Component, PinOfNet };

/// What is known of an element, a line each.
class FactModel : public TableModel {
    Q_OBJECT

public:
    enum Column { Name, Value };

    explicit FactModel(QObject* parent = nullptr);

    /// Values that lead on have the colour of links.
    void setFacts(Facts facts, const QColor& linkColour);
    /// None where there is nothing to go on to. What has no name is a pin of the net, as netFacts lists them.
    [[nodiscard]] std::optional<FactLink> linkOf(int row) const;

private:
    [[nodiscard]] int rows() const override { return static_cast<int>(m_facts.size()); }
    [[nodiscard]] Cell cell(int row, int column) const override;
    [[nodiscard]] QString tip(int row, int column) const override;

    Facts m_facts;
    QColor m_linkColour;
};

}  // namespace ui
