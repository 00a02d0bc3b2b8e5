import freebody as fb
from freebody.questions.spoken import understanding as U, lookup, joining
def spy(names,text,read):
    for r in names.constraint_rows: print(r.connection, r.reaction, getattr(r.measure,'of',None), r.ends)
    for n in names.measures: print(n, getattr(names.measures[n],'of',None))
    print(joining.joints(names,"ladder","wall","normal force"), lookup.heights_of_points(names,"ladder"))
    return orig(names,text,read)
orig=U.understood
import freebody.questions.spoken.understanding as M
import freebody.questions.reading as Rd
Rd.understood=spy
s=fb.System.load("examples/sliding_ladder.yaml")
try: print([x.understood for x in s.asked("In welcher Höhe löst sich die Leiter von der Wand?")])
except Exception as e: print(e)
