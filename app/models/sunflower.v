angle increment: 45
initial line width: 2.2
initial color: 1
tropism direction: 0,1,0
material: 1 stem kind=stem color=0.42,0.54,0.24 roughness=0.8
material: 2 leaf kind=leaf color=0.27,0.45,0.16 roughness=0.65 translucency=0.4
material: 3 ray kind=petal color=0.98,0.74,0.06 roughness=0.55 translucency=0.4
material: 4 disc kind=solid color=0.30,0.19,0.07 roughness=0.9
material: 5 pollen kind=solid color=0.86,0.58,0.10 roughness=0.9
material: 6 bract kind=leaf color=0.36,0.52,0.20 roughness=0.7 translucency=0.3
material: 7 centre kind=solid color=0.36,0.30,0.11 roughness=0.9
organ: l leaf kind=blade material=2 length=25 width=21 petiole=0 widest=0.24 tip=1.1 base=0.35 lobes=0.05 lobe_count=9 fold=16 curl=42
organ: p ray kind=blade material=3 length=9.5 width=2.7 petiole=0 widest=0.45 tip=0.6 base=0.5 fold=14 curl=14
organ: b bract kind=blade material=6 length=6 width=2.4 petiole=0 widest=0.25 tip=1.2 base=0.4 fold=10 curl=20
organ: g receptacle kind=disc material=6 length=1.4 width=20
organ: o floret kind=ball material=5 length=1.5 width=0.62
organ: i floret kind=ball material=4 length=1.1 width=0.72
organ: c floret kind=ball material=7 length=0.8 width=0.66
calendar: p opens=6.4 grown=7.2 turns=8.8 bare=9.8
