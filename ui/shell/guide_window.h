#pragma once

#include <QDialog>

class QLabel;
class QLineEdit;
class QTextBrowser;

namespace ui {

/// Where the guide is: beside the program, as its sample (docs/guide in a build tree).
[[nodiscard]] QString guideFolder();

/// The guide beside the workbench: the Markdown pages of a folder with their pictures, links between them, back and
/// forward, and a line that finds words on all of them. Reads nothing but that folder. Modeless.
class GuideWindow : public QDialog {
    Q_OBJECT

public:
    /// Shows `folder`/README.md, or says that it is not there.
    GuideWindow(const QString& folder, QWidget* parent);

    /// Shows the next occurrence of the words, on this page or another, and from the first page again after the last.
    /// False if no page has them.
    bool find(const QString& words);

private:
    void showContents();
    [[nodiscard]] QWidget* controls();

    QString m_folder;
    QTextBrowser* m_page;  // owned by the dialog, as the rest
    QLineEdit* m_words;
    QLabel* m_result;
};

/// Opens the guide beside `parent`, or brings it to the front.
void showGuide(QWidget& parent);

}  // namespace ui
