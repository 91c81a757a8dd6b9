#include "ui/shell/form_chooser.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <utility>

#include "model/formats/board_forms.h"
#include "ui/common/first_size.h"
#include "ui/common/paths.h"

namespace ui {

namespace {

QTreeWidget* listOf(const std::vector<model::BoardForm>& forms, const std::filesystem::path& path) {
    auto* list = new QTreeWidget;
    list->setHeaderLabels({FormChooser::tr("Form"), FormChooser::tr("File"), FormChooser::tr("Contents")});
    list->setRootIsDecorated(false);
    list->setUniformRowHeights(true);
    for (const model::BoardForm& form : forms) {
        const std::string file = model::fileOf(form, path);
        auto* item =
            new QTreeWidgetItem(list, {QString::fromStdString(std::string(form.format->name)),
                                       file.empty() ? FormChooser::tr("all files") : QFile::decodeName(file.c_str()),
                                       QString::fromStdString(form.contents)});
        item->setToolTip(1, item->text(1));
    }
    list->setCurrentItem(list->topLevelItem(0));
    for (int column = 0; column < list->columnCount(); ++column) {
        list->resizeColumnToContents(column);
    }
    return list;
}

}  // namespace

FormChooser::FormChooser(const std::filesystem::path& path, std::vector<model::BoardForm> forms, QWidget* parent)
    : QDialog(parent), m_forms(std::move(forms)), m_list(listOf(m_forms, path)) {
    setWindowTitle(tr("Choose a form"));
    auto* question = new QLabel(tr("%1 holds %2 boards or forms of a board. The first says most of it.")
                                    .arg(displayName(path))
                                    .arg(m_forms.size()));
    question->setTextFormat(Qt::PlainText);  // names may look like markup
    question->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
    buttons->button(QDialogButtonBox::Open)->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_list, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(question);
    layout->addWidget(m_list, 1);
    layout->addWidget(buttons);
    resizeToScreen(*this, {720, 320});
    m_list->setFocus();
}

void FormChooser::accept() {
    const int row = m_list->indexOfTopLevelItem(m_list->currentItem());
    QDialog::accept();
    if (row >= 0) {
        emit chosen(m_forms[static_cast<std::size_t>(row)]);
    }
}

}  // namespace ui
