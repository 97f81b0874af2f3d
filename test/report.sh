#!/bin/sh
# The HTML report in a browser. Usage: report.sh MADE_UP_REPORT, the program of that name
. "$(dirname "$0")/program.sh"

refuses usage
refuses cannot nowhere/report.html
accepts report.html
check "shown by a browser" /usr/bin/python3 "$here/report/check_report.py" report.html
finish
