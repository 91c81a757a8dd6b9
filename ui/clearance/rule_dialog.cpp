#include "ui/clearance/rule_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <utility>

#include "model/base/assert.h"
#include "model/clearance/rule_file.h"
#include "model/clearance/rule_presets.h"
#include "ui/common/first_size.h"
#include "ui/common/table_view.h"

namespace ui {

namespace {

TableView* tableOf(TableModel& model, const QString& name) {
    auto* table = new TableView(model);
    table->setAccessibleName(name);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setEditTriggers(table->editTriggers() | QAbstractItemView::AnyKeyPressed);
    table->horizontalHeader()->setStretchLastSection(true);
    table->resizeColumnsToContents();
    return table;
}

/// The table in a frame with commands beside it.
template <class Run>
QWidget* boxOf(const QString& title, TableView* table, std::initializer_list<std::pair<QString, Run>> commands) {
    auto* side = new QVBoxLayout;
    for (const auto& [text, run] : commands) {
        auto* button = new QPushButton(text);
        button->setAutoDefault(false);  // Enter in a table edits, it does not press these
        QObject::connect(button, &QPushButton::clicked, table, run);
        side->addWidget(button);
    }
    side->addStretch(1);
    auto* box = new QGroupBox(title);
    auto* row = new QHBoxLayout(box);
    row->addWidget(table, 1);
    row->addLayout(side);
    return box;
}

}  // namespace

RuleDialog::RuleDialog(const model::RuleTable& rules, std::vector<std::string> nets, LengthUnit unit, QWidget* parent)
    : QDialog(parent), m_classes(m_rules, std::move(nets)), m_tolerance(new QLineEdit), m_hint(new QLabel) {
    setWindowTitle(tr("Rules"));
    m_rules.setRules(rules);
    m_rules.setUnit(unit);
    m_hint->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto* all = new QVBoxLayout(this);
    all->addWidget(beginningRow(rules));
    all->addWidget(rulesBox(), 3);
    all->addWidget(toleranceRow());
    all->addWidget(classesBox(), 2);
    all->addWidget(m_hint);
    all->addWidget(buttons);
    resizeToScreen(*this, {940, 600});
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(&m_rules, &RuleModel::refused, m_hint, &QLabel::setText);
    connect(&m_rules, &RuleModel::edited, m_hint, &QLabel::clear);
    m_ruleTable->setCurrentIndex(m_rules.index(0, RuleModel::Kind));
    m_ruleTable->setFocus();
}

/// What is chosen comes in place of the rules in the table. Rules that are those of a preset are shown under its name.
QWidget* RuleDialog::beginningRow(const model::RuleTable& rules) {
    auto* presets = new QComboBox;
    presets->setObjectName(QStringLiteral("presets"));
    const auto add = [this, presets](const QString& name, model::RuleTable table) {
        presets->addItem(name);
        m_beginnings.push_back(std::move(table));
    };
    add(tr("Rules as they are"), rules);
    add(tr("Common boards"), model::defaultRules());
    for (const model::RulePreset& preset : model::rulePresets()) {
        base::Result<model::RuleTable> table = model::parseRules(preset.text);
        ASSERT(table);  // it comes with the program
        add(QString::fromStdString(model::titleOf(preset)), std::move(*table));
    }
    const auto same = std::find(m_beginnings.begin() + 1, m_beginnings.end(), rules);
    presets->setCurrentIndex(same == m_beginnings.end() ? 0 : static_cast<int>(same - m_beginnings.begin()));
    auto* row = new QWidget;
    auto* form = new QFormLayout(row);
    form->setContentsMargins({});
    form->addRow(tr("&Begin with"), presets);
    connect(presets, &QComboBox::activated, this,
            [this](int chosen) { m_rules.replaceRules(m_beginnings[static_cast<std::size_t>(chosen)]); });
    return row;
}

QWidget* RuleDialog::rulesBox() {
    m_ruleTable = tableOf(m_rules, tr("Rules"));
    m_ruleTable->setColumnHidden(RuleModel::Title, true);
    m_ruleTable->setColumnHidden(RuleModel::Result, true);
    m_ruleTable->setColumnWidth(RuleModel::Kind, 170);
    return boxOf<std::function<void()>>(tr("Of several rules of one kind that fit, the last one applies"), m_ruleTable,
                                        {{tr("&Add rule"), [this] { addRule(); }},
                                         {tr("&Remove rule"), [this] { removeRule(); }},
                                         {tr("Move &up"), [this] { moveRule(-1); }},
                                         {tr("Move &down"), [this] { moveRule(1); }}});
}

QWidget* RuleDialog::toleranceRow() {
    m_tolerance->setText(m_rules.tolerance());
    m_tolerance->setObjectName(QStringLiteral("tolerance"));
    m_tolerance->setToolTip(tr("How far a distance may be below its limit and still pass, 0 to 10 µm"));
    auto* row = new QWidget;
    auto* form = new QFormLayout(row);
    form->setContentsMargins({});
    auto* label = new QLabel(tr("&Tolerance of limits"));
    label->setBuddy(m_tolerance);
    // The width that a label says it needs is rounded: its last letter would be cut by the field.
    label->setContentsMargins(0, 0, fontMetrics().averageCharWidth(), 0);
    form->addRow(label, m_tolerance);
    connect(m_tolerance, &QLineEdit::editingFinished, this, &RuleDialog::takeTolerance);
    connect(&m_rules, &RuleModel::edited, this, [this] {  // presets have one of their own
        if (!m_isToleranceRefused) {
            m_tolerance->setText(m_rules.tolerance());
        }
    });
    return row;
}

bool RuleDialog::takeTolerance() {
    const bool wasRefused = std::exchange(m_isToleranceRefused, false);
    m_isToleranceRefused = !m_rules.setTolerance(m_tolerance->text());
    if (!m_isToleranceRefused) {
        m_tolerance->setText(m_rules.tolerance());
        if (wasRefused) {
            m_hint->clear();
        }
    }
    return !m_isToleranceRefused;
}

void RuleDialog::accept() {
    if (takeTolerance()) {
        QDialog::accept();
    } else {
        m_tolerance->setFocus();
        m_tolerance->selectAll();
    }
}

QWidget* RuleDialog::classesBox() {
    m_classTable = tableOf(m_classes, tr("Net classes"));
    m_classTable->setColumnWidth(NetClassModel::Name, 140);
    m_classTable->setColumnWidth(NetClassModel::Nets, 320);
    return boxOf<std::function<void()>>(
        tr("Net classes"), m_classTable,
        {{tr("Add &class"), [this] { addClass(); }}, {tr("R&emove class"), [this] { removeClass(); }}});
}

void RuleDialog::addRule() {
    m_rules.addRule();
    m_ruleTable->setCurrentIndex(m_rules.index(m_rules.rowCount() - 1, RuleModel::Kind));
    m_ruleTable->setFocus();
}

void RuleDialog::removeRule() {
    const int row = m_ruleTable->currentIndex().row();
    if (row >= 0) {
        m_rules.removeRule(row);
        m_ruleTable->setCurrentIndex(m_rules.index(std::min(row, m_rules.rowCount() - 1), RuleModel::Kind));
    }
}

void RuleDialog::moveRule(int by) {
    const QModelIndex at = m_ruleTable->currentIndex();
    if (at.isValid()) {
        m_ruleTable->setCurrentIndex(m_rules.index(m_rules.moveRule(at.row(), by), at.column()));
    }
}

void RuleDialog::addClass() {
    m_classes.addClass();
    m_classTable->setCurrentIndex(m_classes.index(m_classes.rowCount() - 1, NetClassModel::Name));
    m_classTable->setFocus();
}

void RuleDialog::removeClass() {
    const int row = m_classTable->currentIndex().row();
    if (row >= 0) {
        m_classes.removeClass(row);
    }
}

}  // namespace ui
