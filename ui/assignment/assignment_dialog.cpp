#include "ui/assignment/assignment_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/common/first_size.h"
#include "ui/common/table_view.h"

namespace ui {

namespace {

constexpr int kWidestFile = 300;

/// Words about files: names may look like markup.
QLabel* plainLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

}  // namespace

AssignmentDialog::AssignmentDialog(const QString& job, const QString& map,
                                   std::vector<model::gerber::LayerProposal> proposals,
                                   std::vector<model::gerber::LayerProposal> found, QWidget* parent)
    : QDialog(parent), m_found(std::move(found)), m_table(makeTable()), m_hint(plainLabel({})) {
    setWindowTitle(tr("Assign layers"));
    m_hint->setObjectName(QStringLiteral("hint"));
    auto* buttons =
        new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults);
    QPushButton* restore = buttons->button(QDialogButtonBox::RestoreDefaults);
    restore->setText(tr("As &found"));
    restore->setToolTip(tr("What the files are taken to draw without a layer map"));
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(
        plainLabel(tr("What the files of %1 draw. OK reads the board again and remembers it in %2.").arg(job, map)));
    layout->addWidget(m_table, 1);
    layout->addWidget(m_hint);
    layout->addWidget(buttons);
    resizeToScreen(*this, {960, 520});
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(restore, &QPushButton::clicked, this, [this] { show(m_found); });
    connect(&m_model, &AssignmentModel::refused, m_hint, &QLabel::setText);
    connect(&m_model, &AssignmentModel::edited, m_hint, &QLabel::clear);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    const auto enable = [this] { m_ok->setEnabled(m_model.drawsAnything()); };
    connect(&m_model, &AssignmentModel::edited, m_ok, enable);
    connect(&m_model, &QAbstractItemModel::modelReset, m_ok, enable);
    m_table->installEventFilter(this);
    show(std::move(proposals));
    m_table->setFocus();
}

bool AssignmentDialog::takeEnter(const QKeyEvent& event) {
    if (event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter) {
        return false;
    }
    if (event.modifiers().testFlag(Qt::ControlModifier)) {
        m_ok->click();
        return true;
    }
    const QWidget* focus = focusWidget();
    return focus != nullptr &&
           (focus == m_table || m_table->isAncestorOf(focus));  // what it opens or takes there is done
}

void AssignmentDialog::keyPressEvent(QKeyEvent* event) {
    if (!takeEnter(*event)) {
        QDialog::keyPressEvent(event);
    }
}

/// The table would open a cell.
bool AssignmentDialog::eventFilter(QObject* watched, QEvent* event) {
    const bool isAccepting = event->type() == QEvent::KeyPress &&
                             static_cast<const QKeyEvent&>(*event).modifiers().testFlag(Qt::ControlModifier);
    return (isAccepting && takeEnter(static_cast<const QKeyEvent&>(*event))) || QDialog::eventFilter(watched, event);
}

TableView* AssignmentDialog::makeTable() {
    auto* table = new TableView(m_model);
    table->setAccessibleName(tr("Files"));
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setEditTriggers(table->editTriggers() | QAbstractItemView::AnyKeyPressed);
    table->horizontalHeader()->setStretchLastSection(true);
    connect(table, &TableView::enterPressed, table, [table](const QModelIndex& current) {
        if (!current.flags().testFlag(Qt::ItemIsEditable)) {
            return;
        }
        table->edit(current);
        if (auto* choices = qobject_cast<QComboBox*>(table->indexWidget(current))) {
            choices->showPopup();
        }
    });
    return table;
}

void AssignmentDialog::show(std::vector<model::gerber::LayerProposal> proposals) {
    m_model.setProposals(std::move(proposals));
    m_hint->clear();
    m_table->setColumnHidden(AssignmentModel::Board, !m_model.hasBoards());
    m_table->resizeColumnsToContents();
    m_table->setColumnWidth(AssignmentModel::File, std::min(m_table->columnWidth(AssignmentModel::File), kWidestFile));
    m_table->setColumnWidth(AssignmentModel::Draws, std::max(m_table->columnWidth(AssignmentModel::Draws), 140));
    m_table->setColumnWidth(AssignmentModel::Side, std::max(m_table->columnWidth(AssignmentModel::Side), 80));
    m_table->setColumnWidth(AssignmentModel::Plated, std::max(m_table->columnWidth(AssignmentModel::Plated), 100));
    m_table->setCurrentIndex(m_model.index(std::max(m_model.firstUnknown(), 0), AssignmentModel::Draws));
}

}  // namespace ui
