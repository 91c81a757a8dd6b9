#include "ui/shell/dialogs.h"

#include <QAbstractButton>
#include <QFileDialog>
#include <QInputDialog>
#include <QMessageBox>
#include <QStringList>

namespace ui {

namespace {

struct SaveQuestion {
    const char* title;
    QStringList filters;  ///< "Name (*.ending)": the chosen one's ending is added where the name has none
};

void requestSavePath(QWidget& parent, const SaveQuestion& question, const QString& startFolder,
                     const PathResult& answer) {
    auto* dialog = new QFileDialog(&parent, QString::fromUtf8(question.title), startFolder);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(question.filters);
    const auto takeEnding = [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section(QStringLiteral("*."), 1).remove(')'));
    };
    takeEnding(question.filters.first());
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, takeEnding);
    QObject::connect(dialog, &QFileDialog::fileSelected, &parent, answer);
    dialog->open();
}

}  // namespace

void requestBoard(QWidget& parent, BoardForm form, const QString& startFolder, const PathResult& answer) {
    const bool isFolder = form == BoardForm::Folder;
    auto* dialog =
        new QFileDialog(&parent, isFolder ? QStringLiteral("Open an ODB++ folder") : QStringLiteral("Open a board"),
                        startFolder, QStringLiteral("Boards (*.tgz *.tar.gz *.tar *.zip *.txt);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(isFolder ? QFileDialog::Directory : QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, &parent, answer);
    dialog->open();
}

void requestPicturePath(QWidget& parent, const QString& startFolder, const PathResult& answer) {
    requestSavePath(parent, {"Save picture", {"PNG pictures (*.png)"}}, startFolder, answer);
}

void requestWidth(QWidget& parent, int width, int most, const std::function<void(int)>& answer) {
    auto* dialog = new QInputDialog(&parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInputMode(QInputDialog::IntInput);
    dialog->setWindowTitle(QStringLiteral("Save picture of any size"));
    dialog->setLabelText(QStringLiteral("Width in pixels; the height follows from the view:"));
    dialog->setIntRange(16, most);
    dialog->setIntValue(width);
    QObject::connect(dialog, &QInputDialog::intValueSelected, &parent, answer);
    dialog->open();
}

void requestTablePath(QWidget& parent, const QString& startFolder, const PathResult& answer) {
    requestSavePath(parent, {"Export a table", {"Tables (*.csv)"}}, startFolder, answer);
}

void requestStackupPath(QWidget& parent, const QString& startFolder, const PathResult& answer) {
    requestSavePath(parent, {"Export the stack", {"Drawings (*.svg)", "Tables (*.csv)"}}, startFolder, answer);
}

void requestSectionPath(QWidget& parent, const QString& startFolder, const PathResult& answer) {
    requestSavePath(parent, {"Export the section", {"Drawings (*.svg)"}}, startFolder, answer);
}

void requestRulesToOpen(QWidget& parent, const QString& startFolder, const PathResult& answer) {
    auto* dialog = new QFileDialog(&parent, QStringLiteral("Open rules"), startFolder,
                                   QStringLiteral("Rules (*.json);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, &parent, answer);
    dialog->open();
}

void requestReportPath(QWidget& parent, const QString& startFolder, const PathResult& answer) {
    requestSavePath(parent, {"Export clearances", {"Text (*.txt)", "Tables (*.csv)", "JSON (*.json)"}}, startFolder,
                    answer);
}

void requestRulesPath(QWidget& parent, const QString& startFolder, const PathResult& answer) {
    requestSavePath(parent, {"Save rules", {"Rules (*.json)"}}, startFolder, answer);
}

void confirmReset(QWidget& parent, const std::function<void()>& confirmed) {
    auto* question =
        new QMessageBox(QMessageBox::Question, QStringLiteral("Reset settings"),
                        QStringLiteral("Forget panel places, theme, back end and the list of recent boards?"),
                        QMessageBox::Reset | QMessageBox::Cancel, &parent);
    question->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(question, &QMessageBox::buttonClicked, &parent, [question, confirmed](QAbstractButton* button) {
        if (question->standardButton(button) == QMessageBox::Reset) {
            confirmed();
        }
    });
    question->open();
}

}  // namespace ui
