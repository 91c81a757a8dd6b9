#pragma once

#include <QObject>
#include <memory>

#include "model/clearance/nearby.h"
#include "ui/common/lengths.h"
#include "ui/views/board_views.h"
#include "ui/views/plan_painter.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/selection_model.h"

namespace ui {

/// The clearance lens: lights everything up that comes closer to what is selected or highlighted than a distance. All
/// that lies within a millimetre is found once in the background; moving the distance then only cuts a list. In 2D the
/// gaps themselves are painted, which follows the slider at once; where frames of the board are slow, elements are lit
/// once it rests.
class Lens : public QObject {
    Q_OBJECT

public:
    Lens(BoardViews& views, SelectionModel& selection, QObject* parent = nullptr);

    void setBoard(const LoadedBoard& board);
    void setOn(bool isOn);
    /// nm, at most kMostReach.
    void setReach(double nm);
    void setUnit(LengthUnit unit);
    [[nodiscard]] bool isOn() const { return m_isOn; }
    [[nodiscard]] bool isSearching() const { return m_search.isRunning(); }
    /// What is lit, nearest first; of the board's own elements.
    [[nodiscard]] std::span<const model::Nearby> highlighted() const;

    static constexpr double kMostReach = 1e6;

signals:
    /// "12 nearer than 0.2 mm", "nothing selected", …
    void reported(const QString& text);

private:
    void search();
    void deliver();
    void apply();
    void tell();
    void paint(QPainter& painter) const;

    BoardViews& m_views;
    SelectionModel& m_selection;
    BackgroundResult<std::vector<model::Nearby>> m_search;
    std::shared_ptr<const model::Document> m_board;
    BoardPosition m_position;
    QString m_trouble;  ///< why the last search found nothing, if it failed
    std::vector<model::Nearby> m_near;
    std::size_t m_highlightedCount = 0;
    double m_reach = 150'000.0;
    bool m_isOn = false;
    LengthUnit m_unit = LengthUnit::Millimetre;
};

}  // namespace ui
