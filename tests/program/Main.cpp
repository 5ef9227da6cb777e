// SPDX-License-Identifier: MIT
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <QtCore/QFileInfo>

#include "tests/program/Test.h"

namespace crowd::tests {

namespace {

std::map<std::string, TestRun>& allTests()
{
    static std::map<std::string, TestRun> tests;
    return tests;
}

int listTests()
{
    std::cerr << "Name the test to run:\n";
    for (const auto& [name, run] : allTests()) {
        std::cerr << "  " << name << '\n';
    }
    return 2;
}

} // namespace

bool addTest(const char* file, TestRun run)
{
    return allTests()
        .emplace(QFileInfo(QString::fromUtf8(file)).baseName().toStdString(), run)
        .second;
}

} // namespace crowd::tests

int main(int argc, char** argv)
{
    using namespace crowd::tests;
    const auto found = argc > 1 ? allTests().find(argv[1]) : allTests().end();
    if (found == allTests().end()) {
        return listTests();
    }
    std::vector<char*> arguments{argv[0]};
    arguments.insert(arguments.end(), argv + 2, argv + argc);
    arguments.push_back(nullptr); // as main's own list ends
    return found->second(argc - 1, arguments.data());
}
