#include "ui/section/section_panel.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QListView>
#include <QSplitter>

#include "ui/common/panel_parts.h"
#include "ui/workspace/actions.h"

namespace ui {

namespace {

constexpr int kLeastHeight = 250;  // commands, a view that can be read, three lines of notes

}  // namespace

SectionPanel::SectionPanel(SelectionModel& selection, QAbstractItemModel& saved, const ActionSet& actions,
                           QWidget* parent)
    : QWidget(parent),
      m_view(new SectionView(selection)),
      m_list(new QListView),
      m_heights(new QComboBox),
      m_notes(new QLabel) {
    m_heights->addItem(tr("Heights to fill the view"), 0);
    for (const int times : {1, 2, 5, 10, 20, 50, 100}) {
        m_heights->addItem(tr("Heights × %1").arg(times), times);
    }
    m_notes->setWordWrap(true);
    m_notes->hide();
    // A label that wraps says nothing of its height to docks, which would take it from the view.
    setMinimumHeight(kLeastHeight);
    QAction* clear =
        command(*this, "clearSection", tr("Clear"), tr("Remove the line and its section"), [this] { emit cleared(); });
    m_list->setModel(&saved);
    addListCommands();
    auto* row = buttonRow({&actions[ActionId::DrawSection], &actions[ActionId::SectionAlongNet],
                           &actions[ActionId::OpenAlongSection], &actions[ActionId::SaveSection],
                           &actions[ActionId::ExportSection], clear});
    row->addWidget(m_heights);
    auto* all = columnIn(*this, 4);
    all->addLayout(row);
    auto* saves = new QWidget;
    auto* column = columnIn(*saves, 0);
    column->addWidget(new QLabel(tr("Saved sections")));
    column->addWidget(m_list);
    const auto showSaves = [saves, &saved] { saves->setVisible(saved.rowCount() > 0); };
    connect(&saved, &QAbstractItemModel::modelReset, saves, showSaves);
    connect(&saved, &QAbstractItemModel::rowsInserted, saves, showSaves);
    connect(&saved, &QAbstractItemModel::rowsRemoved, saves, showSaves);
    auto* both = new QSplitter;
    both->addWidget(m_view);
    both->addWidget(saves);
    showSaves();
    both->setStretchFactor(0, 5);
    both->setStretchFactor(1, 1);
    both->setChildrenCollapsible(false);
    all->addWidget(both, 1);
    all->addWidget(m_notes);
    connect(m_heights, &QComboBox::currentIndexChanged, this,
            [this] { m_view->setHeightTimes(m_heights->currentData().toDouble()); });
}

void SectionPanel::addListCommands() {
    m_list->addAction(tr("Show"), m_list, [this] { showSaved(m_list->currentIndex()); });
    m_list->addAction(tr("Rename\tF2"), m_list, [this] { m_list->edit(m_list->currentIndex()); });
    auto* remove = m_list->addAction(tr("Delete"), QKeySequence(QKeySequence::Delete), this, [this] {
        if (m_list->currentIndex().isValid()) {
            emit forgotten(m_list->currentIndex().row());
        }
    });
    remove->setShortcutContext(Qt::WidgetShortcut);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_list->setAccessibleName(tr("Saved sections"));
    // A double click is a click that was meant well: the next key does not overwrite the name.
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->setToolTip(tr("Saved sections: a click or Enter shows one, F2 renames it, Del deletes it"));
    m_list->installEventFilter(this);
    connect(m_list, &QListView::clicked, this, &SectionPanel::showSaved);
}

/// Enter is taken here: Qt's `activated` is a click too, on some desktops the first one.
bool SectionPanel::eventFilter(QObject* watched, QEvent* event) {
    const int key = watched == m_list && event->type() == QEvent::KeyPress ? static_cast<QKeyEvent*>(event)->key()
                                                                           : Qt::Key_unknown;
    const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (isEnter && !m_list->isPersistentEditorOpen(m_list->currentIndex())) {  // whose Enter arrives here too
        showSaved(m_list->currentIndex());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void SectionPanel::showSaved(const QModelIndex& saved) {
    if (saved.isValid()) {
        emit chosen(saved.row());
    }
}

void SectionPanel::setNotes(const QString& notes) {
    m_notes->setText(notes);
    m_notes->setVisible(!notes.isEmpty());
}

}  // namespace ui
