#!/bin/sh
# ci_step.sh PROGRAM MESH... - does `PROGRAM in.obj out.obj` enclose every mesh? With ASKS=hull: does
# it write the hull? For a CI job: exit code 1 if not, and the verdicts as JSON in the folder verdicts,
# to be kept with the run.
set -u
program=$1
shift
status=0
claims=candidate-readable,candidate-finite,candidate-solid,contains-input
if [ "${ASKS:-enclosure}" = hull ]; then claims=$claims,is-hull; fi
mkdir -p verdicts
for mesh in "$@"; do
  name=$(basename "$mesh" .obj)
  "$program" "$mesh" "verdicts/$name.out.obj" || { echo "$name: the program failed"; status=1; continue; }
  if "${CONVEXACT:-convexact}" verify "$mesh" "verdicts/$name.out.obj" \
    --asks "${ASKS:-enclosure}" --claims "$claims" --tolerance 1e-12d --json >"verdicts/$name.json"; then
    echo "$name: holds"
  else
    echo "$name: VIOLATED, see verdicts/$name.json"
    status=1
  fi
done
exit $status
