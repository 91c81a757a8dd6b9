#include "ui/dialogs.h"

#include <QAbstractButton>
#include <QFileDialog>
#include <QMessageBox>

namespace ui {

void askForBoard(QWidget& parent, BoardForm form, const QString& startFolder, const PathAnswer& answer) {
    const bool isFolder = form == BoardForm::Folder;
    auto* dialog =
        new QFileDialog(&parent, isFolder ? QStringLiteral("Open an ODB++ folder") : QStringLiteral("Open a board"),
                        startFolder, QStringLiteral("Boards (*.tgz *.tar.gz *.tar *.zip *.txt);;All files (*)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(isFolder ? QFileDialog::Directory : QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, &parent, answer);
    dialog->open();
}

void askForPicturePath(QWidget& parent, const QString& startFolder, const PathAnswer& answer) {
    auto* dialog =
        new QFileDialog(&parent, QStringLiteral("Save picture"), startFolder, QStringLiteral("PNG pictures (*.png)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    QObject::connect(dialog, &QFileDialog::fileSelected, &parent, answer);
    dialog->open();
}

void askToReset(QWidget& parent, const std::function<void()>& confirmed) {
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
