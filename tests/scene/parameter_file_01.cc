// SPDX-License-Identifier: LGPL-2.1-or-later
// Values that reach the handler from .prm, include, JSON and --set, the listing that can be read back, and
// the messages for what is wrong.
#include <softgrain/base/exceptions.h>
#include <softgrain/parameters/parameter_file.h>
#include <softgrain/parameters/parameter_listing.h>

#include <deal.II/base/parameter_handler.h>

#include <fstream>
#include <functional>
#include <iostream>

namespace
{
using namespace softgrain;
using namespace dealii::Patterns;

void declare(dealii::ParameterHandler &prm)
{
  prm.declare_entry("Model", "mpm", Selection("mpm|bpm"), "Which.");
  prm.declare_entry("Steps", "1", Integer(1, 9), "How many.");
  prm.enter_subsection("Young & co.");
  prm.declare_entry("Young's modulus", "1e6", Double(1e-300), "Stiffness. Units: Pa.");
  prm.declare_entry("Ratio", "0.3", Double(1e-300, 0.5), "Units: none.");
  prm.declare_entry("Points", "", List(List(Double(), 2, 2, ","), 0, 5, ";"), "Units: m.");
  prm.declare_entry("Fields", "a", MultipleSelection("a|b"), "Which.");
  prm.declare_entry("On", "true", Bool(), "Whether.");
  prm.enter_subsection("Deep");
  prm.declare_entry("File", "", FileName(), "Where.");
  prm.leave_subsection();
  prm.leave_subsection();
}

void write(const std::string &path, const std::string &text)
{
  std::ofstream(path) << text;
}

void show(const ParameterFile &file)
{
  dealii::ParameterHandler prm;
  declare(prm);
  file.apply(prm);
  print_prm(std::cout, parameter_tree(prm), false);
}

void attempt(const std::function<void()> &action)
{
  try
  {
    action();
    std::cout << "passed\n";
  }
  catch (const InputError &error)
  {
    std::cout << error.what() << '\n';
  }
}

void attempt_file(const std::string &name, const std::string &text)
{
  write(name, text);
  attempt(
      [&]
      {
        dealii::ParameterHandler prm;
        declare(prm);
        ParameterFile(name).apply(prm);
      });
}
} // namespace

int main()
{
  write("base.inc", "set Steps = 3 # later set again\nset Model = bpm\r\n");
  write("good.prm",
        "include base.inc\nset Steps = \\\n  4\nsubsection Young & co.\n  set Points = 0, 1; 2,3\n"
        "  set Young's modulus=5\n  subsection Deep\n    set File = a=b.txt\n  end\nend\n");
  ParameterFile good("good.prm");
  good.set("Young & co./Fields = a, b");
  show(good);
  std::cout << good.where({}, "Model") << ' ' << good.where({"Young & co."}, "Fields") << ' '
            << good.located("'Steps' are few") << '\n';

  write("good.json", "{\n \"Steps\": 4, \"Young & co.\":\n {\"Points\": [[0, 1], [2.5e0, 3]], \"Fields\": "
                     "[\"a\", \"b\"], \"On\": false, \"Deep\": {}}}");
  show(ParameterFile("good.json"));

  {
    dealii::ParameterHandler prm;
    declare(prm);
    std::ofstream listing("listing.prm");
    print_prm(listing, parameter_tree(prm), true);
    listing.close();
    ParameterFile("listing.prm").apply(prm);
    print_prm(std::cout, parameter_tree(prm), true);
    print_markdown(std::cout, parameter_tree(prm));
  }

  attempt_file("1.prm", "set Steps = 10\n");
  attempt_file("2.prm", "set Steps = 2.5\n");
  attempt_file("3.prm", "set Model = bmp\n");
  attempt_file("4.prm", "subsection Young & co.\nset Ratio = 0.6\nend\n");
  attempt_file("5.prm", "subsection Young & co.\nset Young's modulus = nan\nend\n");
  attempt_file("6.prm", "subsection Young & co.\nset Points = 1,2; 3\nend\n");
  attempt_file("7.prm", "subsection Young & co.\nset On = maybe\nend\n");
  attempt_file("8.prm", "subsection Young & co.\nset Fields = c\nend\n");
  attempt_file("9.prm", "set File = x\n");
  attempt_file("10.prm", "subsection\nend\n");
  attempt_file("11.prm", "set Model = mpm \\\n");
  attempt_file("12.prm", "include base.inc extra\n");
  attempt_file("13.prm", "subsection Young & co.\ninclude base.inc\nend\n");
  attempt_file("14.prm", "");
  attempt_file("1.json", "[1, 2]");
  attempt_file("2.json", "{\"Steps\": null}");
  attempt_file("3.json", "{\"Steps\": 2,\n\"Steps\": 3}");
  attempt_file("4.json", "{\"Steps\": 2");
  attempt_file("5.json", "{\"Young & co.\": {\"Points\": [{\"a\": 1}]}}");
  attempt_file("6.json", "");
  attempt([] { ParameterFile("nowhere.prm"); });
  attempt([] { ParameterFile("."); });

  write("names.prm", "subsection Bodies\n  set Names = a, b-2, c_3\nend\n");
  ParameterFile names("names.prm");
  for (const std::string &name : names.names("Bodies"))
    std::cout << name << ' ';
  std::cout << names.names("Walls").size() << '\n';
  for (const std::string list : {"a, , b", "a, b, a", "two words", "value"})
    attempt(
        [&]
        {
          names.set("Bodies/Names=" + list);
          names.names("Bodies");
        });
}
