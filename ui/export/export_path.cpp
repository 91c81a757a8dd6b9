#include "ui/export/export_path.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "ui/common/paths.h"

namespace ui {

namespace {

QString text(std::string_view utf8) {
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

QStringList endingsOf(const model::ExportFormat& format) {
    return text(format.endings).split(' ');
}

/// "STEP (*.step *.stp)"
QString filterOf(const model::ExportFormat& format) {
    return QStringLiteral("%1 (*%2)").arg(text(format.name), endingsOf(format).join(QStringLiteral(" *")));
}

/// An ending that is none of a format stays in the name.
QString withEnding(const QString& path, const model::ExportFormat& format) {
    const model::ExportFormat* named = model::exportFormatOf(toPath(path));
    if (path.isEmpty() || named == &format) {
        return path;
    }
    return (named == nullptr ? path : path.left(path.lastIndexOf('.'))) + endingsOf(format).front();
}

}  // namespace

ExportPath::ExportPath(QString folder, const QString& name, QWidget* parent)
    : QWidget(parent),
      m_folder(std::move(folder)),
      m_format(model::exportFormats().data()),
      m_line(new QLineEdit(QDir::toNativeSeparators(QDir(m_folder).absoluteFilePath(name)))) {
    m_line->setObjectName(QStringLiteral("exportFile"));
    m_line->setAccessibleName(tr("File"));
    setFocusProxy(m_line);
    auto* button = new QPushButton(tr("B&rowse…"));
    button->setAutoDefault(false);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins({});
    row->addWidget(m_line, 1);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, &ExportPath::browse);
    connect(m_line, &QLineEdit::textChanged, this, &ExportPath::changed);
    connect(m_line, &QLineEdit::textEdited, this, [this](const QString& typed) {
        const model::ExportFormat* format = model::exportFormatOf(toPath(typed.trimmed()));
        if (format != nullptr && format != m_format) {
            emit formatTyped(*format);
        }
    });
}

void ExportPath::setFormat(const model::ExportFormat& format) {
    m_format = &format;
    const QString named = withEnding(m_line->text().trimmed(), format);
    if (named != m_line->text()) {  // or the cursor would jump
        m_line->setText(named);
    }
}

QString ExportPath::path() const {
    const QString typed = QDir::fromNativeSeparators(m_line->text().trimmed());
    return typed.isEmpty() ? typed : withEnding(QDir::cleanPath(QDir(m_folder).absoluteFilePath(typed)), *m_format);
}

QString ExportPath::problem() const {
    const QFileInfo file(path());
    const QFileInfo folder(file.path());
    if (m_line->text().trimmed().isEmpty()) {
        return tr("Name a file to export to");
    }
    if (!folder.isDir()) {
        return tr("There is no folder %1").arg(QDir::toNativeSeparators(folder.filePath()));
    }
    if (file.isDir()) {
        return tr("%1 is a folder").arg(QDir::toNativeSeparators(file.filePath()));
    }
    return folder.isWritable() ? QString()
                               : tr("Nothing can be written into %1").arg(QDir::toNativeSeparators(folder.filePath()));
}

void ExportPath::browse() {
    auto* dialog = new QFileDialog(this, tr("Export to"), QFileInfo(path()).path());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setOption(QFileDialog::DontConfirmOverwrite);  // asked once, when it is written
    QStringList filters;
    for (const model::ExportFormat& format : model::exportFormats()) {
        filters += filterOf(format);
    }
    dialog->setNameFilters(filters);
    dialog->selectNameFilter(filterOf(*m_format));
    dialog->selectFile(QFileInfo(path()).fileName());
    connect(dialog, &QFileDialog::filterSelected, this, [filters, dialog](const QString& filter) {
        const QStringList names = dialog->selectedFiles();
        const auto row = static_cast<std::size_t>(std::max<qsizetype>(filters.indexOf(filter), 0));
        if (!names.isEmpty()) {
            dialog->selectFile(QFileInfo(withEnding(names.front(), model::exportFormats()[row])).fileName());
        }
    });
    connect(dialog, &QFileDialog::fileSelected, this, &ExportPath::take);
    dialog->open();
}

void ExportPath::take(const QString& path) {
    const model::ExportFormat* format = model::exportFormatOf(toPath(path));
    m_line->setText(QDir::toNativeSeparators(format != nullptr ? path : withEnding(path, *m_format)));
    if (format != nullptr && format != m_format) {
        emit formatTyped(*format);
    }
}

}  // namespace ui
