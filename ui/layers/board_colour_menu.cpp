#include "ui/layers/board_colour_menu.h"

#include <QCoreApplication>

#include "ui/common/panel_parts.h"

namespace ui {

namespace {

using model::BoardColourChoice;

/// In the order of model::boardColourNames and surfaceFinishNames, which are for files.
constexpr const char* kColourTexts[] = {
    QT_TRANSLATE_NOOP("ui::BoardColourMenu", "Green"), QT_TRANSLATE_NOOP("ui::BoardColourMenu", "Red"),
    QT_TRANSLATE_NOOP("ui::BoardColourMenu", "Blue"),  QT_TRANSLATE_NOOP("ui::BoardColourMenu", "Black"),
    QT_TRANSLATE_NOOP("ui::BoardColourMenu", "White"), QT_TRANSLATE_NOOP("ui::BoardColourMenu", "Yellow"),
    QT_TRANSLATE_NOOP("ui::BoardColourMenu", "Purple")};
constexpr const char* kFinishTexts[] = {QT_TRANSLATE_NOOP("ui::BoardColourMenu", "Gold (ENIG)"),
                                        QT_TRANSLATE_NOOP("ui::BoardColourMenu", "Tin (HASL)"),
                                        QT_TRANSLATE_NOOP("ui::BoardColourMenu", "Bare copper (OSP)")};

QString textOf(model::BoardColour colour) {
    return BoardColourMenu::tr(kColourTexts[static_cast<std::size_t>(colour)]);
}

QString textOf(model::SurfaceFinish finish) {
    return BoardColourMenu::tr(kFinishTexts[static_cast<std::size_t>(finish)]);
}

}  // namespace

BoardColourMenu::BoardColourMenu(LayerModel& layers, Workspace& workspace, QWidget* parent)
    : QMenu(parent),
      m_layers(layers),
      m_part(
          workspace, tr("The colours of the board"),
          [&layers](const BoardColourChoice& chosen) { layers.setBoardColours(chosen); },
          model::session::saveBoardColours) {
    setTitle(tr("&Board colours"));
    connect(this, &QMenu::aboutToShow, this, &BoardColourMenu::fill);
    connect(&workspace, &Workspace::boardOpened, this, [this](const LoadedBoard& board) {
        if (m_part.open()) {
            m_layers.setBoardColours(board.session.boardColours);
        }
    });
}

void BoardColourMenu::fill() {
    clearMenu(*this);
    if (m_layers.document() == nullptr) {
        return;
    }
    BoardColourChoice others = m_layers.boardColours();
    others.silkscreen.reset();  // what it is unchosen depends on the mask
    const model::BoardColours unchosenPrint = model::boardColours(*m_layers.document(), others);
    const model::BoardColours unchosen = model::boardColours(*m_layers.document());
    add(tr("Solder &mask"), model::boardColourNames(), &BoardColourChoice::solderMask, unchosen.solderMask);
    add(tr("&Silkscreen"), model::boardColourNames(), &BoardColourChoice::silkscreen, unchosenPrint.silkscreen);
    add(tr("Surface &finish"), model::surfaceFinishNames(), &BoardColourChoice::finish, unchosen.finish);
}

template <class Value>
void BoardColourMenu::add(const QString& title, const std::vector<std::string>& names,
                          std::optional<Value> BoardColourChoice::*part, Value unchosen) {
    QMenu* menu = addMenu(title);
    const auto addChoice = [&](const QString& text, std::optional<Value> value) {
        BoardColourChoice after = m_layers.boardColours();
        QAction* action = menu->addAction(text);
        action->setCheckable(true);
        action->setChecked(after.*part == value);
        after.*part = value;
        connect(action, &QAction::triggered, this, [this, after] { choose(after); });
    };
    const bool isInJob = (model::coloursInJob(*m_layers.document()).*part).has_value();
    addChoice((isInJob ? tr("From the job: %1") : tr("Default: %1")).arg(textOf(unchosen)), std::nullopt);
    menu->addSeparator();
    for (std::size_t i = 0; i < names.size(); ++i) {
        addChoice(textOf(static_cast<Value>(i)), static_cast<Value>(i));
    }
}

void BoardColourMenu::choose(const BoardColourChoice& chosen) {
    if (chosen != m_layers.boardColours()) {
        m_part.edit(tr("the colours of the board"), m_layers.boardColours(), chosen);
    }
}

}  // namespace ui
