import sys; from mutants import *
from scratch import ROOT
for f in sys.argv[1:]:
    t=(ROOT/f).read_text(); m=mutants_of(t); print(len(m), f)
    for x in m: apply(t,x)
