#pragma once

#include <QPainterPath>
#include <array>
#include <optional>
#include <vector>

#include "model/geometry/discretise.h"
#include "ui/views/board_views.h"
#include "ui/workspace/workspace.h"

namespace ui {

/// Where two boards differ, painted over both views, below names and all else that is painted, while it is shown: a
/// frame around each place, a stronger one around the one that was chosen, and in it, in 2D, what only either board
/// draws there.
class DifferenceMarks : public QObject {
    Q_OBJECT

public:
    /// Orange and blue, which everybody can tell apart.
    static constexpr std::array<QColor, 2> kOnlyColours{QColor(0xf5, 0x9e, 0x2c), QColor(0x3f, 0xa9, 0xff)};
    /// Of more points than that a frame alone is painted.
    static constexpr std::size_t kMostPoints = 100'000;

    struct Place {
        model::Box box;        ///< nm of the board; of a location without extent
        model::LayerId layer;  ///< none: it is on none, or on several
        bool operator==(const Place&) const = default;
    };

    /// Paints over `views` from now on, which must live as long.
    DifferenceMarks(BoardViews& views, Workspace& workspace, QObject* parent = nullptr);

    void setPlaces(std::vector<Place> places);
    void choose(const Place& place);
    /// What only the first and only the second board draws in the chosen place. False if that is too much to be
    /// painted.
    [[nodiscard]] bool setOnly(const std::array<model::PolygonSet, 2>& only);
    /// Ends the choice; false if there was none.
    bool clearChosen();
    void setShown(bool isShown);

    [[nodiscard]] const std::vector<Place>& places() const { return m_places; }
    [[nodiscard]] const std::optional<Place>& chosen() const { return m_chosen; }

private:
    void paint(QPainter& painter, const BoardView& view) const;
    void paintOnly(QPainter& painter, const BoardView& view) const;
    /// Heights as drawn, in mm: of the layers, and of the face that is seen.
    struct Heights {
        std::vector<render::ZRange> layers;
        float face = 0.0F;
    };
    [[nodiscard]] static std::optional<QPolygonF> frameOf(const Place& place, const BoardView& view,
                                                          const Heights& heights);

    BoardViews& m_views;
    Workspace& m_workspace;
    bool m_isShown = false;
    std::vector<Place> m_places;
    std::optional<Place> m_chosen;
    std::array<QPainterPath, 2> m_only;  ///< nm, from the lower left corner of the chosen place
};

}  // namespace ui
