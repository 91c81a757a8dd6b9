#pragma once

#include <QTimer>
#include <QWidget>
#include <set>

#include "model/board/copies.h"
#include "ui/nets/net_model.h"
#include "ui/workspace/selection_model.h"

class QComboBox;
class QSlider;
class QItemSelection;
class QLabel;
class QLineEdit;

namespace ui {

class ActionSet;
class TableView;

/// The nets of the board, or of a step it places: filter, sort, group, highlight. Selected rows are the nets of the
/// selection (ui/workspace/selection_model.h): choosing rows highlights their nets, and what is selected elsewhere
/// marks the rows of its nets. A heading means all nets under it; Enter or a double click shows them, its triangle or
/// Left and Right fold it. In front of each
/// is whether it is drawn and its colour, and while it is highlighted a dot in the colour it is drawn in. Below the
/// table are the properties of the nets that are selected.
class NetsPanel : public QWidget {
    Q_OBJECT

public:
    using Statistics = std::vector<std::shared_ptr<const model::NetStatistics>>;  ///< as LoadedBoard::nets

    /// The commands are those of the menu Nets; the context menu of the table has them too.
    NetsPanel(NetModel& model, SelectionModel& selection, NetStyles& styles, const ActionSet& actions,
              QWidget* parent = nullptr);

    /// The selection must be of this board already. The table begins at its top, or at the net of the selection that
    /// is restored; of a board that `isReadAnew` it stays where it is without one.
    void setBoard(std::shared_ptr<const model::Document> board, Statistics statistics, bool isReadAnew);
    void setUnit(LengthUnit unit);
    /// Whether the table follows the net of what is selected in the views.
    void setFollows(bool isOn) { m_follows = isOn; }
    /// Whether choosing a row also shows the net.
    void setShowsChosen(bool isOn) { m_showsChosen = isOn; }
    [[nodiscard]] TableView& table() { return *m_table; }
    [[nodiscard]] QLineEdit& filterEdit() { return *m_filter; }
    /// By how much the rest is darkened, in percent.
    [[nodiscard]] QSlider& dimSlider() { return *m_dim; }
    /// Opens the dialog for the colour of these nets; not with none.
    void chooseColour(std::vector<model::BoardNet> nets);

signals:
    void showRequested(const std::vector<model::BoardNet>& nets);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void setUpTable();
    void layOutControls(const ActionSet& actions);
    bool takeKey(int key);
    bool foldAt(const QPoint& at);
    void fold(int heading, bool isFolded);
    void groupBySheet();
    [[nodiscard]] int widthFor(NetModel::Column column) const;
    void fitNumbers();
    void fitName();
    void onClicked(const QModelIndex& index);
    void toggleSelected();
    void applyFilter();
    void applyGrouping();
    void applyStep();
    void onArranged();
    void takeFromTable(const QItemSelection& selected, const QItemSelection& deselected);
    void chooseAgain(const QModelIndex& index);
    void onSelectionChanged();
    void showInTable();
    void showDetails();
    void scrollToSelected();
    /// Row of model::StepTree::steps whose nets are listed.
    [[nodiscard]] std::uint32_t step() const;

    NetModel& m_model;
    SelectionModel& m_selection;
    NetStyles& m_styles;
    std::shared_ptr<const model::Document> m_board;
    Statistics m_statistics;
    LengthUnit m_unit = LengthUnit::Millimetre;
    QLineEdit* m_filter;
    QComboBox* m_kind;
    QComboBox* m_group;
    QComboBox* m_step;  ///< hidden while only the board itself has nets
    QSlider* m_dim;
    QLabel* m_summary;
    QLabel* m_details;
    TableView* m_table;
    QTimer m_detailsDue;         ///< what is known of a net comes after the frame that shows it
    bool m_isSyncing = false;    ///< the table is being changed to show what is highlighted
    bool m_isFitting = false;    ///< columns to what they show
    std::set<int> m_setColumns;  ///< those that the user set the width of
    int m_nameNeeded = 0;        ///< the width of the longest name; 0: not measured yet
    bool m_isNameDue = false;    ///< to be measured, once it is arranged and seen
    bool m_isToBegin = false;    ///< at the top, once the rows are arranged
    bool m_isToScroll = false;   ///< to the net of the selection, likewise
    bool m_follows = true;
    bool m_showsChosen = false;
    bool m_isGroupingChosen = false;  ///< by the user
};

}  // namespace ui
