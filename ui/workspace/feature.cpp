#include "ui/workspace/feature.h"

#include <QAbstractButton>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <algorithm>
#include <span>

#include "model/formats/registry.h"
#include "model/text/whole_file.h"
#include "ui/common/paths.h"

namespace ui {

namespace {

/// What has no text of its own is read out as what its tip says it is for, or as its panel.
void nameControls(QWidget& panel, const QString& title) {
    for (QWidget* widget : panel.findChildren<QWidget*>()) {
        if (widget->focusPolicy() != Qt::NoFocus && widget->accessibleName().isEmpty() &&
            qobject_cast<QAbstractButton*>(widget) == nullptr) {
            widget->setAccessibleName(widget->toolTip().isEmpty() ? title : widget->toolTip());
        }
    }
}

/// A path that is typed whole names a file, whatever folder the dialog shows. Qt's line has a list of completions,
/// which takes the keyboard when it comes up; the dialog then writes over what is being typed. So it has none.
class PathDialog : public QFileDialog {
public:
    PathDialog(QWidget* parent, const QString& title, const QString& folder, const QString& filters)
        : QFileDialog(parent, title, folder, filters) {
        if (QLineEdit* field = line()) {
            field->setCompleter(nullptr);
        }
    }

    void accept() override {
        const QLineEdit* field = line();
        const QFileInfo typed(field != nullptr ? field->text().trimmed() : QString());
        if (fileMode() == ExistingFile && typed.isAbsolute() && typed.isFile()) {
            const QString path = QDir::cleanPath(typed.filePath());
            done(QDialog::Accepted);
            emit fileSelected(path);
        } else {
            QFileDialog::accept();
        }
    }

private:
    /// None of dialogs that the desktop brings along.
    [[nodiscard]] QLineEdit* line() const { return findChild<QLineEdit*>(QStringLiteral("fileNameEdit")); }
};

/// A list of patterns that has no room in the line of a dialog is left out of it, and names of kinds remain.
bool areCut(const QString& filters) {
    constexpr qsizetype kMostLetters = 50;
    const QStringList kinds = filters.split(QStringLiteral(";;"));
    return std::ranges::any_of(kinds, [](const QString& kind) { return kind.size() > kMostLetters; });
}

/// Of a file dialog: all boards, then format by format.
QString boardFilters() {
    const auto filter = [](const QString& name, std::span<const model::BoardFormat> formats) {
        return QStringLiteral("%1 (%2);;").arg(name, QString::fromStdString(model::namePatterns(formats)));
    };
    QString filters = filter(Workspace::tr("Boards of all formats"), model::knownFormats());
    for (const model::BoardFormat& format : model::knownFormats()) {
        filters += filter(QString::fromStdString(std::string(format.name)), {&format, 1});
    }
    return filters + Workspace::tr("All files (*)");
}

}  // namespace

void FeatureContext::keepSwitches() {
    for (const Settings::Switch& kept : Settings::kSwitches) {
        QAction& action = actions[kept.id];
        on(kept.id, [this, &kept](bool isOn) { settings.setOn(kept, isOn); });
        restorers.emplace_back([this, &kept, &action, isOnAtFirst = action.isChecked()] {
            if (settings.isOn(kept, isOnAtFirst) != action.isChecked()) {
                action.trigger();
            }
        });
    }
}

void FeatureContext::addPanel(const DockSpec& spec, QWidget& panel) const {
    nameControls(panel, spec.title);
    auto* dock = new QDockWidget(spec.title, &window);
    dock->setObjectName(QLatin1String(spec.name));
    dock->setWidget(&panel);
    QAction& toggle = actions[spec.toggle];
    QObject::connect(&toggle, &QAction::triggered, dock, [dock](bool isOn) {
        dock->setVisible(isOn);
        if (isOn) {
            dock->raise();
        }
    });
    QObject::connect(dock, &QDockWidget::visibilityChanged, &toggle, &QAction::setChecked);
    window.addDockWidget(spec.area, dock);
}

void FeatureContext::raise(QWidget& panel) {
    auto* dock = qobject_cast<QDockWidget*>(panel.parentWidget());
    dock->show();
    dock->raise();
}

void FeatureContext::nameFile(const QString& title, const QString& what, const QStringList& filters,
                              const std::function<void(const QString&)>& take) const {
    auto* dialog = new QFileDialog(&window, title, settings.lastFolder(workspace.boardFolder()));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(filters);
    const auto takeEnding = [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section(QStringLiteral("*."), 1).remove(')'));
    };
    takeEnding(filters.first());
    // The ending follows the filter: the name must not seem to have one.
    const QString board = workspace.board() ? displayName(workspace.board()->request.path) : QString();
    dialog->selectFile((QFileInfo(board).completeBaseName() + ' ' + what).simplified().replace('.', '_'));
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, takeEnding);
    QObject::connect(dialog, &QFileDialog::fileSelected, &workspace, [this, take](const QString& path) {
        settings.setLastFolder(QFileInfo(path).absolutePath());
        take(path);
    });
    dialog->open();
}

void FeatureContext::saveFile(const QString& title, const QString& what, const QStringList& filters,
                              const std::function<base::Result<std::string>(const QString&)>& make) const {
    nameFile(title, what, filters, [&board = workspace, make](const QString& path) {
        const base::Result<std::string> content = make(path);
        if (!content) {
            board.reportSaved(content.error(), path);
            return;
        }
        board.files().add(
            nullptr, [file = toPath(path), content] { return model::writeWholeFile(file, *content); },
            [&board, path](const base::Status& written) { board.reportSaved(written, path); });
    });
}

QDialog& FeatureContext::openFile(const QString& title, const QString& filters, const QString& folder,
                                  const std::function<void(const QString&)>& open) const {
    auto* dialog = new PathDialog(&window, title, folder, filters);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::HideNameFilterDetails, areCut(filters));
    dialog->setFileMode(filters.isEmpty() ? QFileDialog::Directory : QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, &workspace, open);
    dialog->open();
    return *dialog;
}

QDialog& FeatureContext::openBoardPath(const QString& title, BoardPath kind,
                                       const std::function<void(const QString&)>& open) const {
    return openFile(title, kind == BoardPath::File ? boardFilters() : QString(),
                    settings.boardsFolder(workspace.boardFolder()), [this, open](const QString& path) {
                        settings.setBoardsFolder(QFileInfo(path).absolutePath());
                        open(path);
                    });
}

}  // namespace ui
