#pragma once

#include <QObject>
#include <memory>

#include "model/clearance/nearby.h"
#include "ui/clearance/lens_painter.h"
#include "ui/views/board_views.h"
#include "ui/views/plan_painter.h"
#include "ui/workspace/background_result.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// The clearance lens: highlights everything that comes closer to what is selected or highlighted than a distance. All
/// that lies within a millimetre is found once in the background; moving the distance then only cuts a list. In 2D the
/// spacings themselves are painted, the nearest with their numbers, which follows the slider at once; where frames of
/// the board are slow, elements are highlighted once it rests.
class Lens : public QObject {
    Q_OBJECT

public:
    Lens(BoardViews& views, Workspace& workspace, QObject* parent = nullptr);

    void setOn(bool isOn);
    /// nm, at most kMostReach.
    void setReach(double nm);
    [[nodiscard]] bool isOn() const { return m_isOn; }
    [[nodiscard]] bool isSearching() const { return m_search.isRunning(); }
    /// What is highlighted, nearest first; of the board's own elements.
    [[nodiscard]] std::span<const model::Nearby> highlighted() const;

    /// What was written over the 2D view when it was painted last; lines are rows of `highlighted`.
    [[nodiscard]] const std::vector<LensPainter::Number>& numbers() const { return m_numbers; }

    static constexpr double kMostReach = 1e6;

signals:
    /// "12 nearer than 0.2 mm", "nothing selected", …
    void reported(const QString& text);

private:
    void setBoard(const LoadedBoard& board);
    void search();
    void deliver();
    void apply();
    void tell();
    void paint(QPainter& painter);

    BoardViews& m_views;
    Workspace& m_workspace;
    SelectionModel& m_selection;
    BackgroundResult<std::vector<model::Nearby>> m_search;
    std::shared_ptr<const model::Document> m_board;
    QString m_trouble;  ///< why the last search found nothing, if it failed
    std::vector<model::Nearby> m_near;
    std::size_t m_highlightedCount = 0;
    std::vector<LensPainter::Number> m_numbers;
    double m_reach = 150'000.0;
    bool m_isOn = false;
};

}  // namespace ui
