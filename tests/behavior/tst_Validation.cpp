// SPDX-License-Identifier: MIT
#include <cstdio>

#include <QtTest/QTest>

#include "behavior/validation/Validation.h"
#include "tests/program/Test.h"

using crowd::behavior::ValidationRow;

/// Our crowd walks as people are known to walk. Prints the table.
class ValidationTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyRowIsWithinWhatIsPublished();
    void aRowOutsideSaysSo();
    void weidmannsCurve();
};

void ValidationTest::everyRowIsWithinWhatIsPublished()
{
    const std::vector<ValidationRow> rows = crowd::behavior::validate();
    QVERIFY(rows.size() >= 32);
    QByteArray outside;
    for (const ValidationRow& row : rows) {
        std::puts(row.text().c_str());
        if (!row.isWithin()) {
            outside += row.text() + '\n';
        }
    }
    QVERIFY2(outside.isEmpty(), outside.constData());
}

void ValidationTest::aRowOutsideSaysSo()
{
    ValidationRow row{"jumping", "m", -0.0625, 1.0, 2.5};
    QVERIFY(!row.isWithin());
    QVERIFY(row.text().starts_with("jumping "));
    QVERIFY(row.text().ends_with(" -0.063  (1.000 to 2.500) m  <- outside"));
    row.measured = 2.5;
    QVERIFY(row.isWithin());
    QVERIFY(row.text().ends_with(" 2.500  (1.000 to 2.500) m"));
}

void ValidationTest::weidmannsCurve()
{
    QVERIFY(std::abs(crowd::behavior::weidmannSpeed(1.0) - 1.06) < 0.01);
    QVERIFY(std::abs(crowd::behavior::weidmannSpeed(2.0) - 0.61) < 0.01);
    QVERIFY(std::abs(crowd::behavior::weidmannSpeed(5.4)) < 1e-9);
}

CROWD_TEST(ValidationTest)
#include "tst_Validation.moc"
