#include "ui/clearance/waive_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace ui {

WaiveDialog::WaiveDialog(const QString& location, const QString& author, QWidget* parent)
    : QDialog(parent), m_reason(new QLineEdit), m_author(new QLineEdit(author)) {
    setWindowTitle(tr("Waive"));
    m_reason->setObjectName(QStringLiteral("reason"));
    m_author->setObjectName(QStringLiteral("author"));
    // OK waits for both.
    m_reason->setPlaceholderText(tr("Needed: why it is no failure"));
    m_author->setPlaceholderText(tr("Needed: who says so"));
    auto* where = new QLabel(location);
    where->setObjectName(QStringLiteral("location"));
    where->setTextFormat(Qt::PlainText);
    where->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    auto* form = new QFormLayout(this);
    form->addRow(where);
    form->addRow(tr("&Reason"), m_reason);
    form->addRow(tr("&Author"), m_author);
    form->addRow(buttons);
    setMinimumWidth(fontMetrics().averageCharWidth() * 60);
    const auto update = [this, ok = buttons->button(QDialogButtonBox::Ok)] {
        ok->setEnabled(!reason().isEmpty() && !this->author().isEmpty());
    };
    for (QLineEdit* line : {m_reason, m_author}) {
        connect(line, &QLineEdit::textChanged, this, update);
    }
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    update();
}

QString WaiveDialog::reason() const {
    return m_reason->text().trimmed();
}

QString WaiveDialog::author() const {
    return m_author->text().trimmed();
}

}  // namespace ui
