#pragma once

#include <QObject>
#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "ui/clearance/clearance_map_legend.h"
#include "ui/clearance/clearance_map_picture.h"
#include "ui/views/board_views.h"
#include "ui/views/probing.h"

namespace ui {

/// The clearance map: colours every location of a copper layer by how far it is from what is selected or highlighted,
/// and with nothing selected by the spacing between nets there (model::BoardDistances: copies on panels too). Follows
/// the selection, the layer and the cameras; another range only colours anew.
class ClearanceMapOverlay : public QObject {
    Q_OBJECT

public:
    /// Follows the pointer over the board that `probing` announces.
    ClearanceMapOverlay(BoardViews& views, Probing& probing, Workspace& workspace, QObject* parent = nullptr);

    /// Asked for the copper layer to map; none: there is none to be seen.
    void setLayer(std::function<model::LayerId()> layer) { m_layer = std::move(layer); }
    void setOn(bool isOn);
    /// The end of the colours, nm.
    void setReach(double nm);
    /// Other layers are to be seen, or another one is the current one.
    void refresh() { m_refresh.start(); }

    [[nodiscard]] bool isOn() const { return m_isOn; }
    /// Is something still to be worked out?
    [[nodiscard]] bool isPending() const;
    /// Null while there is nothing to paint.
    [[nodiscard]] const model::BoardDistances* field() const { return m_field.get(); }
    [[nodiscard]] ClearanceMapPicture& picture(BoardView::Kind kind) {
        return *m_pictures[static_cast<std::size_t>(kind)];
    }
    /// What the map shows at a location: "spacing 0.12 mm"; empty where it shows nothing.
    [[nodiscard]] QString textAt(base::PointD location) const;
    [[nodiscard]] ClearanceMapLegend legend() const;

signals:
    /// "TOP: spacing between nets", "TOP has no copper of two nets", …
    void reported(const QString& text);

private:
    void setBoard(const LoadedBoard& board);
    void pointAt(std::optional<base::PointD> location);

    struct Question {
        model::LayerId layer;
        std::vector<model::BoardElement> targets;  ///< none: spacings between nets
        bool operator==(const Question&) const = default;
    };

    void ask();
    void work(Question question);
    void deliver();
    void show(std::shared_ptr<const model::BoardDistances> field);
    [[nodiscard]] std::vector<model::BoardElement> targets() const;
    [[nodiscard]] QString targetName() const;
    [[nodiscard]] QString reasonFor(const base::Error& error) const;
    void paintLegend(QPainter& painter, const BoardView& view) const;

    BoardViews& m_views;
    Workspace& m_workspace;
    SelectionModel& m_selection;
    std::array<ClearanceMapPicture*, 2> m_pictures{};  ///< as BoardViews::both
    std::function<model::LayerId()> m_layer;
    std::shared_ptr<const model::Document> m_board;
    std::optional<Question> m_question;  ///< that the field answers, or will
    std::shared_ptr<const model::BoardDistances> m_field;
    std::optional<base::PointD> m_cursor;
    double m_reach = 0.5e6;
    bool m_isOn = false;
    QTimer m_refresh;  ///< several changes are one
    BackgroundResult<std::shared_ptr<const model::BoardDistances>> m_work;
};

}  // namespace ui
