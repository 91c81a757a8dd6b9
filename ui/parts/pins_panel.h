#pragma once

#include <QWidget>

#include "ui/parts/linked_table.h"
#include "ui/parts/pin_model.h"

class QLabel;

namespace ui {

/// The pins of what was chosen last outside of this panel: of the selected components, or of the highlighted nets; of
/// the nets of selected elements that are of no component; of the whole board while nothing is chosen, or more than
/// PartPicking::kMostElements. So a component shows its nets here and a net its components. Selected rows are the pins
/// that are selected in the views, both ways; Enter, a double click or the menu of a row shows them there, and the menu
/// highlights their nets and selects the component.
class PinsPanel : public QWidget {
    Q_OBJECT

public:
    PinsPanel(PinModel& model, PartPicking& parts, SelectionModel& selection, const ActionSet& actions,
              QWidget* parent = nullptr);

    /// The selection must be of this board already.
    void setBoard(const LoadedBoard& board);
    /// Whether choosing a row also shows the pin in the views.
    void setShowsChosen(bool isOn) { m_showsChosen = isOn; }
    /// While it is not seen, behind another panel for one, the list stays as it is: listing thousands of pins takes
    /// part of a frame.
    void setSeen(bool isSeen);
    [[nodiscard]] LinkedTable& table() { return *m_table; }

signals:
    void exportRequested();

private:
    /// What the list follows once it is seen.
    enum class Due { Nothing, Parts, Nets };

    void follow(Due what);
    void layOut();
    void addRowCommands(const ActionSet& actions);
    void followParts();
    void followNets();
    void listPinsOfParts();
    /// `elements`: so many are selected that have these nets; none, the nets are highlighted.
    void listPinsOfNets(const std::vector<model::BoardNet>& nets, std::size_t elements);
    void listAllPins();
    void takeRows(const std::vector<int>& rows);
    void markChosen();
    void highlightNets();

    PinModel& m_model;
    PartPicking& m_parts;
    SelectionModel& m_selection;
    LinkedTable* m_table;
    QLabel* m_whose;
    Due m_due = Due::Nothing;
    bool m_isSeen = false;    ///< docks that are closed from the start say nothing
    bool m_isTaking = false;  ///< what is selected or highlighted becomes the rows
    bool m_showsChosen = false;
};

}  // namespace ui
