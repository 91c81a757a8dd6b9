// What is set is held at once and written on another thread; what other programs wrote is taken over then.
#include "ui/workspace/settings_file.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QtTest>

using ui::SettingsFile;

class SettingsFileTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void whatWasSetLastIsHeldWhileItIsWritten() {
        {
            SettingsFile file(iniFile());
            for (int i = 0; i < 300; ++i) {
                const QString key = QString::number(i % 7);
                file.setValue(key, i);
                if (i % 10 == 0) {
                    QTest::qWait(1);
                }
                QCOMPARE(file.value(key).toInt(), i);
                if (i % 50 == 49) {
                    file.clear();
                    QCOMPARE(file.value(key, "none").toString(), "none");
                }
            }
            file.setValue("last", QStringList{"a", "b"});
        }
        QCOMPARE(text(), "[General]\nlast=a, b\n");
        QCOMPARE(SettingsFile(iniFile()).value("last").toStringList(), (QStringList{"a", "b"}));
    }

    void whatAnotherProgramWritesIsTakenOverWithTheNextThatIsSet() {
        SettingsFile file(iniFile());
        file.setValue("recent", QStringList{"/a"});
        QTRY_COMPARE(text(), "[General]\nrecent=/a\n");
        write("[General]\nrecent=/b, /a\n");
        QCOMPARE(file.value("recent").toStringList(), QStringList{"/a"});
        file.setValue("dim", 30);
        QTRY_COMPARE(file.value("recent").toStringList(), (QStringList{"/b", "/a"}));
        QCOMPARE(file.value("dim").toInt(), 30);
    }

    void whatIsSetAsItIsIsNotWritten() {
        write("# mine\n[General]\ndim=30\n");
        {
            SettingsFile file(iniFile());
            file.setValue("dim", "30");
        }
        QVERIFY2(text().startsWith("# mine"), "QSettings keeps no comments");
    }

    void whatCannotBeWrittenIsHeldAndWrittenLater() {
        SettingsFile file(iniFile());
        QVERIFY(file.isWritable());
        QVERIFY(QDir(m_folder->path()).mkdir("settings.ini"));  // in the way
        file.setValue("dim", 30);
        QTest::qWait(50);
        QCOMPARE(file.value("dim").toInt(), 30);
        QVERIFY(QDir(m_folder->path()).rmdir("settings.ini"));
        file.setValue("unit", "mil");
        QTRY_COMPARE(text(), "[General]\ndim=30\nunit=mil\n");
    }

private:
    [[nodiscard]] QString iniFile() const { return m_folder->filePath("settings.ini"); }
    /// As another program: what QSettings shares in this one the thread sanitizer takes for races.
    [[nodiscard]] QByteArray text() const {
        QFile file(iniFile());
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void write(const QByteArray& text) const {
        QFile file(iniFile());
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(SettingsFileTest)
#include "settings_file_test.moc"
