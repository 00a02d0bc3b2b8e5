import freebody as fb,sys
s=fb.load(sys.argv[1])
for q in sys.argv[2:]:
    try: print(q,'->',fb.solve(s,ask=[q]) )
    except Exception as e: print(q,'ERR',type(e),e)
